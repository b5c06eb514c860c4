// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_avoid_objects.h"

namespace soarbox::world {

Vec3 SteerAvoidObjects(const AgentMotion& self, std::span<const Obstacle> obstacles, float look_ahead_s) {
  Vec3 sum;
  const float reach_m = look_ahead_s * self.speed;
  for (const Obstacle& obstacle : obstacles) {
    const Vec3 offset = obstacle.center - self.position;
    const float ahead = Dot(offset, self.forward);
    if (ahead <= 0 || ahead >= reach_m + obstacle.radius_m) continue;
    const Vec3 lateral = offset - self.forward * ahead;
    const float clearance = obstacle.radius_m + self.radius;
    if (LengthSquared(lateral) < clearance * clearance) sum -= lateral;
  }
  return sum;
}

}  // namespace soarbox::world
