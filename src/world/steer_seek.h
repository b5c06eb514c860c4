// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent_motion.h"

namespace soarbox::world {

/// Towards the target, minus the present velocity (Reynolds, 1999, seek with the distance as desired speed). Grows with
/// the distance without a limit.
Vec3 SteerSeek(const AgentMotion& self, Vec3 target);

/// Away from the danger, minus the present velocity.
Vec3 SteerFlee(const AgentMotion& self, Vec3 danger);

}  // namespace soarbox::world
