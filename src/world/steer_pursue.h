// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent_motion.h"

namespace soarbox::world {

/// Seeks the quarry's predicted position after the time that self needs to cover the present distance (Reynolds, 1999),
/// at most max_prediction_s ahead. If self stands still, max_prediction_s is used.
Vec3 SteerPursue(const AgentMotion& self, const AgentMotion& quarry, float max_prediction_s);

/// Flees the same predicted position.
Vec3 SteerEvade(const AgentMotion& self, const AgentMotion& menace, float max_prediction_s);

}  // namespace soarbox::world
