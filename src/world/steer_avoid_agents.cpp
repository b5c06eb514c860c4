// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_avoid_agents.h"

#include <limits>

namespace soarbox::world {
namespace {

constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();
constexpr float kNearlyParallel = 0.707f;

struct Threat {
  std::uint32_t index = kNobody;
  float time_s = 0;
};

Vec3 Ahead(const AgentMotion& agent, float time_s) {
  return agent.position + agent.forward * (agent.speed * time_s);
}

// When the two come nearest at their present velocities; 0 if they keep their distance.
float NearestApproachTime(const AgentMotion& self, const AgentMotion& other) {
  const Vec3 relative = other.velocity - self.velocity;
  const float speed = Length(relative);
  if (!(speed > 0)) return 0;
  return Dot(relative / speed, self.position - other.position) / speed;
}

std::uint32_t FirstTouching(std::size_t self_index, std::span<const AgentMotion> all,
                            std::span<const std::uint32_t> candidates) {
  const AgentMotion& self = all[self_index];
  std::uint32_t first = kNobody;
  for (const std::uint32_t i : candidates) {
    if (i >= first || i == self_index || !all[i].alive) continue;
    const float reach = self.radius + all[i].radius;
    if (LengthSquared(all[i].position - self.position) < reach * reach) first = i;
  }
  return first;
}

Threat MostImminent(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> candidates,
                    float look_ahead_s) {
  const AgentMotion& self = all[self_index];
  const float clearance_squared = 4 * self.radius * self.radius;
  Threat threat{kNobody, look_ahead_s};
  for (const std::uint32_t i : candidates) {
    const AgentMotion& other = all[i];
    if (i == self_index || !other.alive) continue;
    const float time_s = NearestApproachTime(self, other);
    const bool sooner =
        time_s < threat.time_s || (time_s == threat.time_s && i < threat.index && threat.index != kNobody);
    if (time_s < 0 || !sooner) continue;
    if (LengthSquared(Ahead(self, time_s) - Ahead(other, time_s)) < clearance_squared) threat = {i, time_s};
  }
  return threat;
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
  const std::uint32_t touching = FirstTouching(self_index, all, candidates);
  if (touching != kNobody) {
    const Vec3 away = self.position - all[touching].position;
    const Vec3 sideways = away - self.forward * Dot(away, self.forward);
    if (LengthSquared(sideways) > 0) return sideways;
  }
  const Threat threat = MostImminent(self_index, all, candidates, look_ahead_s);
  if (threat.index == kNobody) return {};
  return self.left * DodgingSide(self, all[threat.index], threat.time_s);
}

}  // namespace soarbox::world
