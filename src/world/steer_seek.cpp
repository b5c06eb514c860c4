// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_seek.h"

namespace soarbox::world {

Vec3 SteerSeek(const AgentMotion& self, Vec3 target) {
  return (target - self.position) - self.velocity;
}

Vec3 SteerFlee(const AgentMotion& self, Vec3 danger) {
  return (self.position - danger) - self.velocity;
}

}  // namespace soarbox::world
