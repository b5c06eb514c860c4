// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent_motion.h"

namespace soarbox::world {

/// Along forward by the missing speed (m/s), within -max_force_n .. max_force_n.
Vec3 SteerTargetSpeed(const AgentMotion& self, float speed_mps, float max_force_n);

}  // namespace soarbox::world
