// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_avoid_agents.h"

#include <cmath>
#include <limits>

namespace soarbox::world {
namespace {

constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();
constexpr float kNearlyParallel = 0.707f;
// Lets rounding err on the side of looking closer, so that the order of the candidates never shows.
constexpr float kSlack = 1.0001f;

struct Threat {
  std::uint32_t index = kNobody;
  float time_s = 0;
};

Vec3 Ahead(const AgentMotion& agent, float time_s) {
  return agent.position + agent.forward * (agent.speed * time_s);
}

struct Findings {
  std::uint32_t touching = kNobody;
  Threat threat;
};

// The two come nearest at the time t that makes their distance smallest at their present velocities:
// t = w . (p - p_other) / |w|^2 with the relative velocity w. Most candidates drop out before the division.
void Consider(const AgentMotion& self, const AgentMotion& other, std::uint32_t index, Vec3 apart, Threat& threat) {
  const Vec3 relative = other.velocity - self.velocity;
  const float closing = Dot(relative, apart);
  const float speed_squared = LengthSquared(relative);
  if (speed_squared > 0 && (closing < 0 || closing > threat.time_s * speed_squared * kSlack)) return;
  const float time_s = speed_squared > 0 ? closing / speed_squared : 0.0f;
  const bool sooner =
      time_s < threat.time_s || (time_s == threat.time_s && threat.index != kNobody && index < threat.index);
  if (!sooner) return;
  const float clearance = 2 * self.radius;
  if (LengthSquared(Ahead(self, time_s) - Ahead(other, time_s)) < clearance * clearance) threat = {index, time_s};
}

Findings LookAround(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> candidates,
                    float look_ahead_s) {
  const AgentMotion& self = all[self_index];
  Findings found;
  found.threat.time_s = look_ahead_s;
  for (const std::uint32_t i : candidates) {
    const AgentMotion& other = all[i];
    if (i == self_index || !other.alive) continue;
    const Vec3 apart = self.position - other.position;
    const float squared = LengthSquared(apart);
    const float radii = self.radius + other.radius;
    if (squared < radii * radii && i < found.touching) found.touching = i;
    const float reach = 2 * self.radius + (std::abs(self.speed) + std::abs(other.speed)) * found.threat.time_s;
    if (squared <= reach * reach * kSlack) Consider(self, other, i, apart, found.threat);
  }
  return found;
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

float AvoidAgentsRange(const AgentMotion& self, float look_ahead_s, float max_speed_mps, float max_radius_m) {
  const float touching = self.radius + max_radius_m;
  const float missing = 2 * self.radius + (self.speed + max_speed_mps) * look_ahead_s;
  return touching > missing ? touching : missing;
}

Vec3 SteerAvoidAgents(std::size_t self_index, std::span<const AgentMotion> all,
                      std::span<const std::uint32_t> candidates, float look_ahead_s) {
  const AgentMotion& self = all[self_index];
  const Findings found = LookAround(self_index, all, candidates, look_ahead_s);
  if (found.touching != kNobody) {
    const Vec3 away = self.position - all[found.touching].position;
    const Vec3 sideways = away - self.forward * Dot(away, self.forward);
    if (LengthSquared(sideways) > 0) return sideways;
  }
  if (found.threat.index == kNobody) return {};
  return self.left * DodgingSide(self, all[found.threat.index], found.threat.time_s);
}

}  // namespace soarbox::world
