// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_group.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soarbox::world {
namespace {

constexpr float kAlwaysNearRadii = 3.0f;

// Calls visit(other) for each neighbour, in the order of `others`. Returns their number.
template <typename Visit>
int ForEachNeighbour(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                     const Neighbourhood& neighbourhood, Visit visit) {
  const AgentMotion& self = all[self_index];
  const float near_squared = kAlwaysNearRadii * self.radius * kAlwaysNearRadii * self.radius;
  const float far = std::max(0.0f, neighbourhood.max_distance_m);
  const float far_squared = far * far;
  const float min_cosine = std::cos(neighbourhood.max_angle_deg * (std::numbers::pi_v<float> / 180.0f));
  int count = 0;
  for (const std::uint32_t i : others) {
    if (i == self_index) continue;
    const Vec3 offset = all[i].position - self.position;
    const float squared = LengthSquared(offset);
    if (squared >= near_squared) {
      if (squared > far_squared) continue;
      if (!(Dot(self.forward, offset) > min_cosine * std::sqrt(squared))) continue;
    }
    visit(all[i], offset, squared);
    ++count;
  }
  return count;
}

}  // namespace

float NeighbourhoodRange(float radius_m, float max_distance_m) {
  return std::max(kAlwaysNearRadii * radius_m, max_distance_m);
}

Vec3 SteerSeparate(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                   const Neighbourhood& neighbourhood) {
  Vec3 sum;
  const int count =
      ForEachNeighbour(self_index, all, others, neighbourhood, [&sum](const AgentMotion&, Vec3 offset, float squared) {
        if (squared > 0) sum -= offset / squared;
      });
  return count > 0 ? Normalized(sum / static_cast<float>(count)) : Vec3{};
}

Vec3 SteerCombine(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                  const Neighbourhood& neighbourhood) {
  Vec3 sum;
  const int count = ForEachNeighbour(self_index, all, others, neighbourhood,
                                     [&sum](const AgentMotion& other, Vec3, float) { sum += other.position; });
  return count > 0 ? Normalized(sum / static_cast<float>(count) - all[self_index].position) : Vec3{};
}

Vec3 SteerAlign(std::size_t self_index, std::span<const AgentMotion> all, std::span<const std::uint32_t> others,
                const Neighbourhood& neighbourhood) {
  Vec3 sum;
  const int count = ForEachNeighbour(self_index, all, others, neighbourhood,
                                     [&sum](const AgentMotion& other, Vec3, float) { sum += other.forward; });
  return count > 0 ? Normalized(sum / static_cast<float>(count) - all[self_index].forward) : Vec3{};
}

}  // namespace soarbox::world
