// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/agent.h"
#include "world/bodies_around.h"

// What agents can see and hear of each other. Fast enough for crowds in which all agents look at all others.
namespace soarbox::world {

/// Whether there is a free line of sight from the eyes of `from` to the middle of the target or to its eyes. Only the
/// two agents themselves do not block it. `around`: AroundEyes(from, ...) if the target is in that view, or null.
bool SeesAgent(const Agent& from, const Agent& target, const BodiesAround* around = nullptr);
/// The bodies that may hide others from an agent, in a view of this range and width. Worthwhile for an agent that looks
/// at many others.
BodiesAround AroundEyes(const Agent& from, float range_m, float angle_deg);

/// Whether the segment straight ahead of an agent is free: at this height above its feet, up to this distance from its
/// position (World::RayCast hits nothing).
bool IsFreeAhead(const Agent& from, float ahead_m, float height_m);

/// All agents within this distance, and possibly some farther ones, in ascending id. Several threads may call it at a
/// time if World::PrepareForReaders was called since an agent last moved.
std::vector<EntityId> AgentsNear(const Agent& agent, float range_m);

}  // namespace soarbox::world
