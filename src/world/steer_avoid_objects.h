// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "world/agent_motion.h"

namespace soarbox::world {

/// A sphere to walk around.
struct Obstacle {
  Vec3 center;
  float radius_m = 0;
};

/// Steers sideways around each obstacle ahead within look_ahead_s, by its offset from the line of motion (after
/// Reynolds, 1999, obstacle avoidance). The contributions add up; zero if exactly head-on.
Vec3 SteerAvoidObjects(const AgentMotion& self, std::span<const Obstacle> obstacles, float look_ahead_s);

}  // namespace soarbox::world
