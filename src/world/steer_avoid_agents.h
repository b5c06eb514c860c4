// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>

#include "world/agent_motion.h"

namespace soarbox::world {

/// Beyond this centre distance no agent of at most that speed and radius can matter to SteerAvoidAgents.
float AvoidAgentsRange(const AgentMotion& self, float look_ahead_s, float max_speed_mps, float max_radius_m);

/// Sidesteps other agents (after Reynolds, 1999, unaligned collision avoidance). An agent that touches self is pushed
/// away from, sideways; failing that, the one with the earliest near miss within look_ahead_s is dodged to the left or
/// right (unit length). candidates are indices into all, in any order; self_index and dead agents are skipped. Of
/// several that touch, or that miss at the same time, the one with the lowest index counts.
Vec3 SteerAvoidAgents(std::size_t self_index, std::span<const AgentMotion> all,
                      std::span<const std::uint32_t> candidates, float look_ahead_s);

}  // namespace soarbox::world
