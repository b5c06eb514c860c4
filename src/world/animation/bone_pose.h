// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/math.h"
#include "world/rotation.h"

namespace soarbox::world {

/// The pose of a bone relative to its parent or its model: a scale, then a rotation, then a translation. Only bones of
/// models from files have a scale.
struct BonePose {
  Vec3 position;
  Quat orientation;
  Vec3 scale{1, 1, 1};
  Vec3 Apply(Vec3 v) const { return position + Rotate(orientation, {v.x * scale.x, v.y * scale.y, v.z * scale.z}); }
  friend bool operator==(const BonePose& a, const BonePose& b) = default;
};

/// The pose b, which is relative to the pose a, in the coordinates of a's parent. Scales are multiplied axis by axis:
/// the result has no shear.
inline BonePose operator*(const BonePose& a, const BonePose& b) {
  return {a.Apply(b.position),
          a.orientation * b.orientation,
          {a.scale.x * b.scale.x, a.scale.y * b.scale.y, a.scale.z * b.scale.z}};
}
/// The inverse of a pose without a scale.
inline BonePose Inverse(const BonePose& a) {
  const Quat back = Conjugate(a.orientation);
  return {Rotate(back, -a.position), back};
}

/// A rotation about a unit axis.
inline Quat Turn(Vec3 axis, float radians) {
  const float s = std::sin(radians / 2);
  return {std::cos(radians / 2), axis.x * s, axis.y * s, axis.z * s};
}

/// Interpolates between two rotations along the shorter arc; returns b at share 1.
inline Quat Between(Quat a, Quat b, float share) {
  const float dot = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  const float other = dot < 0 ? -share : share, own = 1 - share;
  return Normalized(
      {own * a.w + other * b.w, own * a.x + other * b.x, own * a.y + other * b.y, own * a.z + other * b.z});
}
inline Vec3 Between(Vec3 a, Vec3 b, float share) {
  return a + (b - a) * share;
}

}  // namespace soarbox::world
