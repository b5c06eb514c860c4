// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/entity_ids.h"
#include "world/physics_trees.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Finds the owners of all movable bodies that overlap a sensor. The sensor itself is not in `world`. Each owner is
/// listed once, in ascending order.
void FindInside(btCollisionWorld& world, const AllBodies& bodies, btCollisionObject& sensor,
                std::vector<EntityId>& found);

}  // namespace soarbox::world
