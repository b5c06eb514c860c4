// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_path.h"

#include "world/steer_seek.h"

namespace soarbox::world {

Vec3 SteerStayOnPath(const AgentMotion& self, const Path& path, float look_ahead_s) {
  if (path.empty()) return {};
  const Vec3 future = self.position + self.velocity * look_ahead_s;
  const Vec3 nearest = path.NearestTo(future).point;
  if (Distance(future, nearest) < path.radius_m()) return {};
  return SteerSeek(self, nearest);
}

Vec3 SteerFollowPath(const AgentMotion& self, const Path& path, float look_ahead_s) {
  if (path.empty()) return {};
  const float offset_m = look_ahead_s * self.speed;
  const Vec3 future = self.position + self.velocity * look_ahead_s;
  const Path::Nearest now = path.NearestTo(self.position);
  const Path::Nearest then = path.NearestTo(future);

  const bool right_way =
      offset_m > 0 ? now.distance_along_m < then.distance_along_m : now.distance_along_m > then.distance_along_m;
  const bool in_tube = Distance(future, then.point) < path.radius_m();
  if (right_way && in_tube) return {};
  return SteerSeek(self, path.PointAt(now.distance_along_m + offset_m));
}

}  // namespace soarbox::world
