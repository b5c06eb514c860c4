// SPDX-License-Identifier: BSD-2-Clause
#include "world/rotation.h"

#include <algorithm>
#include <numbers>

namespace soarbox::world {
namespace {

constexpr float kRadians = std::numbers::pi_v<float> / 180.0f;
constexpr float kDegrees = 180.0f / std::numbers::pi_v<float>;

Quat About(Vec3 axis, float angle_rad) {
  const float s = std::sin(angle_rad / 2);
  return {std::cos(angle_rad / 2), axis.x * s, axis.y * s, axis.z * s};
}

}  // namespace

bool IsFinite(float value) {
  return std::isfinite(value);
}
bool IsFinite(Vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
bool IsFinite(Quat q) {
  return std::isfinite(q.w) && IsFinite(Vec3{q.x, q.y, q.z});
}

Quat Normalized(Quat q) {
  const float length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}

Quat FromRotationVector(Vec3 degrees) {
  return About({1, 0, 0}, degrees.x * kRadians) * About({0, 1, 0}, degrees.y * kRadians) *
         About({0, 0, 1}, degrees.z * kRadians);
}

Vec3 ToRotationVector(Quat rotation) {
  const Vec3 x = Rotate(rotation, {1, 0, 0});
  const Vec3 y = Rotate(rotation, {0, 1, 0});
  const Vec3 z = Rotate(rotation, {0, 0, 1});
  // z.x is sin(y). If it is almost +-1, the two outer rotations have the same axis.
  if (z.x >= 0.9999999f) return {std::atan2(x.y, y.y) * kDegrees, 90, 0};
  if (z.x <= -0.9999999f) return {-std::atan2(x.y, y.y) * kDegrees, -90, 0};
  return {std::atan2(-z.y, z.z) * kDegrees, std::asin(z.x) * kDegrees, std::atan2(-y.x, x.x) * kDegrees};
}

Vec3 ToPitchYawRoll(Quat rotation) {
  const Vec3 x = Rotate(rotation, {1, 0, 0});
  const Vec3 y = Rotate(rotation, {0, 1, 0});
  const Vec3 z = Rotate(rotation, {0, 0, 1});
  return {std::atan2(y.z, y.y) * kDegrees, std::atan2(z.x, z.z) * kDegrees, std::atan2(x.y, x.x) * kDegrees};
}

Quat FromAxes(Vec3 x, Vec3 y, Vec3 z) {
  // Computes the largest component first, so that no division is by a small number.
  const float trace = x.x + y.y + z.z;
  Quat q;
  if (trace > 0) {
    q = {trace + 1, y.z - z.y, z.x - x.z, x.y - y.x};
  } else if (x.x >= y.y && x.x >= z.z) {
    q = {y.z - z.y, 1 + x.x - y.y - z.z, y.x + x.y, z.x + x.z};
  } else if (y.y >= z.z) {
    q = {z.x - x.z, y.x + x.y, 1 + y.y - x.x - z.z, z.y + y.z};
  } else {
    q = {x.y - y.x, z.x + x.z, z.y + y.z, 1 + z.z - x.x - y.y};
  }
  return Normalized(q);
}

Quat ShortestArc(Vec3 from, Vec3 to) {
  const Vec3 a = Normalized(from), b = Normalized(to);
  if (LengthSquared(a) == 0 || LengthSquared(b) == 0 || !IsFinite(a) || !IsFinite(b)) return {};
  const float cosine = Dot(a, b);
  if (cosine >= 1.0f) return {};
  if (cosine < -0.999999f) {
    Vec3 axis = Cross({1, 0, 0}, a);
    if (LengthSquared(axis) < 1e-8f) axis = Cross({0, 1, 0}, a);
    axis = Normalized(axis);
    return {0, axis.x, axis.y, axis.z};
  }
  const Vec3 axis = Cross(a, b);
  return Normalized(Quat{1 + cosine, axis.x, axis.y, axis.z});
}

bool FacingAlong(Vec3 forward, Quat& rotation) {
  const Vec3 z = Normalized(forward);
  const Vec3 x = Normalized(Cross({0, 1, 0}, z));
  if (!IsFinite(z) || !IsFinite(x) || LengthSquared(x) < 0.5f) return false;
  rotation = FromAxes(x, Cross(z, x), z);
  return true;
}

}  // namespace soarbox::world
