// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/physics_bullet.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Computes the contacts of capsules with planes by a formula. This is the contact of every agent that stands on the
/// ground. The contact point is the one that Bullet's general algorithm for convex shapes finds: the lowest point of
/// the capsule.
void FindCapsulesOnPlanes(btCollisionDispatcher& dispatcher);

}  // namespace soarbox::world
