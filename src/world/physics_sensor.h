// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/entity_ids.h"
#include "world/physics_trees.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Finds the owners of the bodies that can move and overlap a sensor, which is not in the world itself. Each once, in
/// ascending order.
void FindInside(btCollisionWorld& world, const AllBodies& bodies, btCollisionObject& sensor,
                std::vector<EntityId>& found);

}  // namespace soarbox::world
