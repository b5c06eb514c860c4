// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_pursue.h"

#include <algorithm>

#include "world/steer_seek.h"

namespace soarbox::world {
namespace {

Vec3 MeetingPoint(const AgentMotion& self, const AgentMotion& other, float max_prediction_s) {
  const float limit_s = std::max(0.0f, max_prediction_s);
  const float speed = Length(self.velocity);
  const float distance = Distance(self.position, other.position);
  const float time_s = speed > 0 ? std::min(distance / speed, limit_s) : limit_s;
  return other.position + other.velocity * time_s;
}

}  // namespace

Vec3 SteerPursue(const AgentMotion& self, const AgentMotion& quarry, float max_prediction_s) {
  return SteerSeek(self, MeetingPoint(self, quarry, max_prediction_s));
}

Vec3 SteerEvade(const AgentMotion& self, const AgentMotion& menace, float max_prediction_s) {
  return SteerFlee(self, MeetingPoint(self, menace, max_prediction_s));
}

}  // namespace soarbox::world
