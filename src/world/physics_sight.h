// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/physics_bullet.h"
#include "world/physics_ray.h"

// What is on a segment, for the physics_*.cpp files only. Reads the broad phase's trees and changes nothing, so that
// several threads may ask at a time.
namespace soarbox::world {

class CrowdBroadphase;

struct FirstHit {
  const btCollisionObject* body = nullptr;
  RayEntry entry;
};
/// The first body that the segment enters; of several at one point, the one of the smallest owner.
FirstHit FindFirstHit(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to);

/// A body and the bounding box in which the broad phase has it.
struct BoxedBody {
  btDbvtVolume box;
  const btCollisionObject* body = nullptr;
};
/// Appends the bodies whose boxes touch that box, in the order of the trees.
void FindInBox(const CrowdBroadphase& bodies, const btVector3& low, const btVector3& high,
               std::vector<BoxedBody>& found);
/// FindFirstHit of these bodies alone.
FirstHit FindFirstHit(const std::vector<BoxedBody>& bodies, const btVector3& from, const btVector3& to);

/// Whether nothing but these two is on the segment in front of the target. The target may be null.
bool IsClear(const CrowdBroadphase& bodies, const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
             const btCollisionObject* target);

}  // namespace soarbox::world
