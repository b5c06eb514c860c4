// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent_motion.h"
#include "world/random.h"

namespace soarbox::world {

/// Where a wandering agent leans to; both in -1..1.
struct WanderState {
  float side = 0;
  float up = 0;
};

/// A walk in two dimensions (Reynolds, "Steering Behaviors For Autonomous Characters", 1999): each call moves the two
/// values by at most 12 * delta and returns left * side + up * up.
Vec3 SteerWander(const AgentMotion& self, WanderState& state, RandomStream& random, float delta);

}  // namespace soarbox::world
