// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/agent_motion.h"

namespace soarbox::world {

/// A force along forward that corrects the speed (m/s), clamped to -max_force_n .. max_force_n.
Vec3 SteerTargetSpeed(const AgentMotion& self, float speed_mps, float max_force_n);

}  // namespace soarbox::world
