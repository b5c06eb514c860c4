// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent_motion.h"

namespace soarbox::world {

/// Seeks the place where the quarry will be when self could have covered the present distance (Reynolds, 1999), at
/// most max_prediction_s ahead. A self that stands looks as far ahead as it may.
Vec3 SteerPursue(const AgentMotion& self, const AgentMotion& quarry, float max_prediction_s);

/// Flees that place.
Vec3 SteerEvade(const AgentMotion& self, const AgentMotion& menace, float max_prediction_s);

}  // namespace soarbox::world
