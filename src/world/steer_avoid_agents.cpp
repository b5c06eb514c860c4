// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_avoid_agents.h"

#include <algorithm>
#include <cmath>

namespace soarbox::world {
namespace {

constexpr float kNearlyParallel = 0.707f;
// Lets rounding err on the side of looking closer, so that the order of the candidates never shows.
constexpr float kSlack = 1.0001f;

Vec3 Ahead(const AgentMotion& agent, float time_s) {
  return agent.position + agent.forward * (agent.speed * time_s);
}

float AwayFrom(float leftness) {
  return leftness > 0 ? -1.0f : 1.0f;
}

// +1: to the left, -1: to the right, 0: the other one will have to give way.
float DodgingSide(const AgentMotion& self, const AgentMotion& threat, float time_s) {
  const float parallelness = Dot(self.forward, threat.forward);
  if (parallelness < -kNearlyParallel) return AwayFrom(Dot(Ahead(threat, time_s) - self.position, self.left));
  if (parallelness > kNearlyParallel) return AwayFrom(Dot(threat.position - self.position, self.left));
  return threat.speed <= self.speed ? AwayFrom(Dot(self.left, threat.velocity)) : 0.0f;
}

}  // namespace

Lookout::Lookout(std::size_t self_index, std::span<const AgentMotion> all, float look_ahead_s, float max_speed_mps,
                 float max_radius_m)
    : all_(all),
      self_(all[self_index]),
      self_index_(static_cast<std::uint32_t>(self_index)),
      fastest_mps_(std::abs(self_.speed) + max_speed_mps),
      touching_m_(self_.radius + max_radius_m),
      threat_s_(look_ahead_s) {}

float Lookout::range_m() const {
  return std::max(touching_m_, 2 * self_.radius + fastest_mps_ * threat_s_);
}

void Lookout::Look(std::uint32_t index) {
  const AgentMotion& other = all_[index];
  if (index == self_index_ || !other.alive) return;
  const Vec3 apart = self_.position - other.position;
  const float squared = LengthSquared(apart);
  const float radii = self_.radius + other.radius;
  if (squared < radii * radii && index < touching_) touching_ = index;
  const float reach = 2 * self_.radius + (std::abs(self_.speed) + std::abs(other.speed)) * threat_s_;
  if (squared <= reach * reach * kSlack) Consider(other, index, apart);
}

// The two come nearest at the time t that makes their distance smallest at their present velocities:
// t = w . (p - p_other) / |w|^2 with the relative velocity w. Most candidates drop out before the division.
void Lookout::Consider(const AgentMotion& other, std::uint32_t index, Vec3 apart) {
  const Vec3 relative = other.velocity - self_.velocity;
  const float closing = Dot(relative, apart);
  const float speed_squared = LengthSquared(relative);
  if (speed_squared > 0 && (closing < 0 || closing > threat_s_ * speed_squared * kSlack)) return;
  const float time_s = speed_squared > 0 ? closing / speed_squared : 0.0f;
  const bool sooner = time_s < threat_s_ || (time_s == threat_s_ && threat_ != kNobody && index < threat_);
  if (!sooner) return;
  const float clearance = 2 * self_.radius;
  if (LengthSquared(Ahead(self_, time_s) - Ahead(other, time_s)) >= clearance * clearance) return;
  threat_ = index;
  threat_s_ = time_s;
}

Vec3 Lookout::Force() const {
  if (touching_ != kNobody) {
    const Vec3 away = self_.position - all_[touching_].position;
    const Vec3 sideways = away - self_.forward * Dot(away, self_.forward);
    if (LengthSquared(sideways) > 0) return sideways;
  }
  if (threat_ == kNobody) return {};
  return self_.left * DodgingSide(self_, all_[threat_], threat_s_);
}

}  // namespace soarbox::world
