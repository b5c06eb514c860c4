// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/agent.h"
#include "world/bodies_around.h"

// What agents can see and hear of each other, fast enough for crowds in which everybody looks at everybody.
namespace soarbox::world {

/// HasLineOfSight for an agent as the target: whether the other's eyes see this point of it. `around`: AroundEyes of
/// the one who looks, if the point is within that range of it.
bool SeesAgent(const Agent& from, const Agent& target, Vec3 point, const BodiesAround* around = nullptr);
/// What may hide others from an agent up to this distance on the ground. Pays off for an agent that looks at many
/// nearby.
BodiesAround AroundEyes(const Agent& from, float range_m);

/// All agents within this distance, and perhaps some beyond, in ascending id. Several threads may ask at a time if
/// World::PrepareForReaders was called since an agent last moved.
std::vector<EntityId> AgentsNear(const Agent& agent, float range_m);

}  // namespace soarbox::world
