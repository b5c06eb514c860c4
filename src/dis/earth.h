// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "dis/pdu.h"
#include "world/math.h"

namespace soarbox::dis {

/// A place on or above the ellipsoid of WGS 84.
struct Geodetic {
  double latitude_deg = 0;   ///< North is positive.
  double longitude_deg = 0;  ///< East is positive.
  double height_m = 0;       ///< Above the ellipsoid.
};

/// Geocentric metres (NIMA TR8350.2, section 4.3).
Vector ToGeocentric(const Geodetic& place);
/// The inverse, by iteration; exact to 0.1 mm within 1,000 km of the ground.
Geodetic ToGeodetic(const Vector& place);

/// Where the flat world of a scenario is on the earth. Its origin is at the anchor. Its ground is the plane that
/// touches the ellipsoid's parallel surface there: x points east, y up, and -z north.
///
/// Distances and angles are the same on both sides. At 5 km the plane is 2 m off the round earth. Immutable.
class LocalFrame {
 public:
  explicit LocalFrame(const Geodetic& anchor);

  const Geodetic& anchor() const { return anchor_; }
  Vector ToEarth(const Vector& local) const;
  Vector ToLocal(const Vector& geocentric) const;
  /// Of directions and velocities.
  Vector TurnToEarth(const Vector& local) const;
  Vector TurnToLocal(const Vector& geocentric) const;

  /// The orientation on the earth of a body that looks along `forward` and stands upright along `up`. Both have length
  /// 1 and are at right angles.
  Euler ToEuler(const Vector& forward, const Vector& up) const;
  /// The direction in which a body of this orientation looks.
  Vector ForwardOf(const Euler& euler) const;
  /// A vector along the body's axes (x forward, y right, z down), such as a rotation or a place in it, as a local
  /// vector.
  Vector FromBodyAxes(const Euler& euler, const Vector& in_body) const;

 private:
  Geodetic anchor_;
  Vector origin_;
  Vector east_, north_, up_;  ///< Geocentric.
};

inline Vector ToVector(const world::Vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
inline world::Vec3 ToVec3(const Vector& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(const Vector& v, double by) {
  return {v.x * by, v.y * by, v.z * by};
}
inline double Dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector Cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace soarbox::dis
