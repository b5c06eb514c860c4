// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>

#include "world/physics_bullet.h"

// Where segments meet the shapes of bodies, exactly, for the physics_*.cpp files only: Bullet casts a point against
// every convex shape by iterating, which costs thousands of instructions for each.
namespace soarbox::world {

struct RayEntry {
  btScalar fraction = 1;  ///< 0 at the segment's beginning, 1 at its end.
  btVector3 normal;       ///< Of the surface there, in the world.
};

/// Where the segment enters the body; nothing if it misses it or begins inside. A plane is entered from both sides.
std::optional<RayEntry> EntryOf(const btCollisionObject& body, const btVector3& from, const btVector3& to);

}  // namespace soarbox::world
