// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>

namespace soarbox::world {

/// A point, direction or colour. Metres, or 0..1 per channel. Right-handed, y up; an unrotated agent looks along +z.
struct Vec3 {
  float x = 0, y = 0, z = 0;

  friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(Vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Vec3 operator*(float s, Vec3 a) { return a * s; }
  friend Vec3 operator/(Vec3 a, float s) { return {a.x / s, a.y / s, a.z / s}; }
  Vec3& operator+=(Vec3 b) { return *this = *this + b; }
  Vec3& operator-=(Vec3 b) { return *this = *this - b; }
  Vec3& operator*=(float s) { return *this = *this * s; }
  friend bool operator==(Vec3 a, Vec3 b) = default;
};

inline float Dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 Cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float LengthSquared(Vec3 a) {
  return Dot(a, a);
}
inline float Length(Vec3 a) {
  return std::sqrt(Dot(a, a));
}
inline float Distance(Vec3 a, Vec3 b) {
  return Length(b - a);
}
/// The unit vector along a; the zero vector is returned unchanged.
inline Vec3 Normalized(Vec3 a) {
  const float length = Length(a);
  return length > 0 ? a / length : Vec3{};
}

/// A rotation as a unit quaternion.
struct Quat {
  float w = 1, x = 0, y = 0, z = 0;
  friend bool operator==(Quat a, Quat b) = default;
};

/// Hamilton product: first the rotation b, then the rotation a.
inline Quat operator*(Quat a, Quat b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline Vec3 Rotate(Quat q, Vec3 v) {
  const Vec3 u{q.x, q.y, q.z};
  const Vec3 t = 2.0f * Cross(u, v);
  return v + q.w * t + Cross(u, t);
}

}  // namespace soarbox::world
