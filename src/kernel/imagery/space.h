// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cmath>

namespace soarbox::kernel::imagery {

/// A point or a direction. The program that fills the scene determines the unit (metres in the sandbox).
struct Vec3 {
  double x = 0, y = 0, z = 0;

  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const Vec3& a, double factor) { return {a.x * factor, a.y * factor, a.z * factor}; }
};

inline double Dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 Cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double Length(const Vec3& a) {
  return std::sqrt(Dot(a, a));
}
inline double Distance(const Vec3& a, const Vec3& b) {
  return Length(b - a);
}

/// An axis-aligned box in world coordinates, boundaries included.
struct Box {
  Vec3 low, high;

  friend bool operator==(const Box&, const Box&) = default;
  void Include(const Vec3& point);
  void Include(const Box& other);
  bool Touches(const Box& other) const;
  bool Contains(const Box& other) const;
  Vec3 Middle() const { return {(high.x + low.x) / 2, (high.y + low.y) / 2, (high.z + low.z) / 2}; }
  double Volume() const { return (high.x - low.x) * (high.y - low.y) * (high.z - low.z); }
  /// The distance between two boxes; 0 if they touch or overlap.
  double Gap(const Box& other) const;
};

/// The pose of a node in its parent's frame: scaled, then rotated about x, y and z (radians), then translated.
struct Pose {
  Vec3 position, rotation, scale{1, 1, 1};

  friend bool operator==(const Pose&, const Pose&) = default;
};

/// An affine map: linear * point + shift.
class Transform {
 public:
  Transform() = default;
  explicit Transform(const Pose& pose);

  Vec3 operator()(const Vec3& point) const { return Turn(point) + shift_; }
  /// Applies only the linear part, for directions.
  Vec3 Turn(const Vec3& direction) const;
  /// Applies the transposed linear part; support functions need it to transform directions to the local frame.
  Vec3 TurnTransposed(const Vec3& direction) const;
  friend Transform operator*(const Transform& outer, const Transform& inner);
  const Vec3& shift() const { return shift_; }
  /// The scale factor if the map preserves angles, else a negative number.
  double UniformScale() const;

  /// The map as a rotation after a scaling along (possibly non-orthogonal) axes.
  struct Parts {
    Vec3 position;
    std::array<double, 4> rotation{};  ///< x, y, z, w of a unit quaternion.
    Vec3 scale;                        ///< The diagonal of the scaling.
  };
  Parts Decompose() const;

 private:
  using Rows = std::array<Vec3, 3>;

  Rows rows_{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 shift_;
};

}  // namespace soarbox::kernel::imagery
