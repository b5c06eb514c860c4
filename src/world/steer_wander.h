// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent_motion.h"
#include "world/world_random.h"

namespace soarbox::world {

/// The present deviation of a wandering agent; both values are in -1..1.
struct WanderState {
  float side = 0;
  float up = 0;
};

/// A random walk in two dimensions (Reynolds, "Steering Behaviors For Autonomous Characters", 1999). Each call changes
/// the two values by at most 12 * delta and returns left * side + up * up.
Vec3 SteerWander(const AgentMotion& self, WanderState& state, RandomStream& random, float delta);

}  // namespace soarbox::world
