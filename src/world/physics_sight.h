// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/physics_bullet.h"

// Rays through crowds, for the physics_*.cpp files only: Bullet finds where a ray meets a capsule by iterating, which
// costs thousands of instructions for each body whose bounding box is touched.
namespace soarbox::world {

/// False only if the segment certainly misses the body: an upright capsule that it passes at the side, a plane that
/// both of its ends are above.
bool MayHit(const btCollisionObject& object, const btVector3& from, const btVector3& to);

/// The first body on a segment, without those that it certainly misses.
struct FirstHit final : btCollisionWorld::ClosestRayResultCallback {
  FirstHit(const btVector3& from, const btVector3& to);
  bool needsCollision(btBroadphaseProxy* proxy) const override;
};

/// Whether nothing but these two is on the segment in front of the target. The target may be null.
bool IsClear(const btCollisionWorld& world, const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
             const btCollisionObject* target);

}  // namespace soarbox::world
