// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_speed.h"

#include <algorithm>

namespace soarbox::world {

Vec3 SteerTargetSpeed(const AgentMotion& self, float speed_mps, float max_force_n) {
  return self.forward * std::clamp(speed_mps - self.speed, -max_force_n, max_force_n);
}

}  // namespace soarbox::world
