// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "world/agent_motion.h"

namespace soarbox::world {

/// Something to walk around, as a sphere.
struct Obstacle {
  Vec3 center;
  float radius_m = 0;
};

/// Sidesteps each obstacle that lies ahead within look_ahead_s of walking, by its offset from the line of sight
/// (after Reynolds, 1999, obstacle avoidance). The contributions add up; zero if exactly head-on.
Vec3 SteerAvoidObjects(const AgentMotion& self, std::span<const Obstacle> obstacles, float look_ahead_s);

}  // namespace soarbox::world
