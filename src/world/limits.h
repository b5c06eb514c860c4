// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>

#include "world/math.h"
#include "world/physics_world.h"

// For the world's own .cpp files: clamps values from scripts to what the physics can compute with. Values must be
// finite.
namespace soarbox::world {

inline Vec3 Limit(Vec3 v, float limit) {
  return {std::clamp(v.x, -limit, limit), std::clamp(v.y, -limit, limit), std::clamp(v.z, -limit, limit)};
}
inline Vec3 LimitPosition(Vec3 v) {
  return Limit(v, PhysicsWorld::kMaxCoordinate_m);
}
inline Vec3 LimitVelocity(Vec3 v) {
  return Limit(v, PhysicsWorld::kMaxSpeed_mps);
}
inline Vec3 LimitForce(Vec3 v) {
  return Limit(v, PhysicsWorld::kMaxForce_n);
}

}  // namespace soarbox::world
