// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/physics_bullet.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Finds by a formula where capsules touch planes, the contact of everybody who stands on the ground. The point is the
/// same as Bullet finds with its search for any convex shape: the lowest one of the capsule.
void FindCapsulesOnPlanes(btCollisionDispatcher& dispatcher);

}  // namespace soarbox::world
