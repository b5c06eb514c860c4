// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/animation/bone_pose.h"
#include "world/math.h"

namespace soarbox::model {

/// An affine transform: the images of the three axes, and that of the origin.
struct Frame {
  world::Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, place;

  world::Vec3 Turned(world::Vec3 v) const { return x * v.x + y * v.y + z * v.z; }
  world::Vec3 Placed(world::Vec3 v) const { return Turned(v) + place; }
  float Determinant() const { return Dot(Cross(x, y), z); }
  /// Transforms a normal. Under uneven scales this requires the cofactors.
  world::Vec3 TurnedNormal(world::Vec3 n) const {
    const world::Vec3 turned = Cross(y, z) * n.x + Cross(z, x) * n.y + Cross(x, y) * n.z;
    return Normalized(Determinant() < 0 ? -turned : turned);
  }
};

/// First b, then a.
inline Frame operator*(const Frame& a, const Frame& b) {
  return {a.Turned(b.x), a.Turned(b.y), a.Turned(b.z), a.Placed(b.place)};
}

inline Frame FrameOf(const world::BonePose& pose) {
  const auto axis = [&pose](world::Vec3 along) { return pose.Apply(along) - pose.position; };
  return {axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1}), pose.position};
}

}  // namespace soarbox::model
