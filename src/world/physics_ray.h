// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>

#include "world/physics_bullet.h"

// Exact intersections of segments with the shapes of bodies; for the physics_*.cpp files only. Bullet computes them
// iteratively for every convex shape, which costs thousands of instructions each.
namespace soarbox::world {

struct RayEntry {
  btScalar fraction = 1;  ///< 0 at the start of the segment, 1 at its end.
  btVector3 normal;       ///< Normal of the surface at that point, in world coordinates.
};

/// The point at which the segment enters the body; nothing if it misses the body or starts inside. A plane can be
/// entered from both sides.
std::optional<RayEntry> EntryOf(const btCollisionObject& body, const btVector3& from, const btVector3& to);

}  // namespace soarbox::world
