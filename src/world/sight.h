// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/agent.h"
#include "world/bodies_around.h"

// What agents can see and hear of each other, fast enough for crowds in which everybody looks at everybody.
namespace soarbox::world {

/// Whether the other's eyes have a line of sight to the middle of the target or to its eyes: nothing but these two is
/// on it in front of the target. `around`: AroundEyes of the other, if the target is in that view.
bool SeesAgent(const Agent& from, const Agent& target, const BodiesAround* around = nullptr);
/// What may hide others from an agent up to this distance on the ground, in a view so wide. Pays off for an agent that
/// looks at many nearby.
BodiesAround AroundEyes(const Agent& from, float range_m, float angle_deg);

/// Whether nothing is straight ahead of an agent, so far from its place and so much above its feet: World::RayCast hits
/// nothing.
bool IsFreeAhead(const Agent& from, float ahead_m, float height_m);

/// All agents within this distance, and perhaps some beyond, in ascending id. Several threads may ask at a time if
/// World::PrepareForReaders was called since an agent last moved.
std::vector<EntityId> AgentsNear(const Agent& agent, float range_m);

}  // namespace soarbox::world
