// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/agent.h"

// What agents can see and hear of each other, fast enough for crowds in which everybody looks at everybody.
namespace soarbox::world {

/// The same as HasLineOfSight for an agent as the target: whether anything hides this point of it from the other's
/// eyes.
bool SeesAgent(const Agent& from, const Agent& target, Vec3 point);

/// All agents within this distance, and perhaps some beyond, in ascending id. Several threads may ask at a time if
/// World::PrepareForReaders was called since an agent last moved.
std::vector<EntityId> AgentsNear(const Agent& agent, float range_m);

}  // namespace soarbox::world
