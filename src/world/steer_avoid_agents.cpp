// SPDX-License-Identifier: BSD-2-Clause
#include "world/steer_avoid_agents.h"

#include <algorithm>

namespace soarbox::world {
namespace {

/// Cosine of 45 degrees: smaller angles between two directions, in either sense, count as parallel.
constexpr float kAlongEachOther = 0.707f;

/// The position of an agent after this time at constant velocity.
Vec3 PlaceIn(const AgentMotion& who, float seconds) {
  return who.position + who.forward * (who.speed * seconds);
}

}  // namespace

Lookout::Lookout(std::size_t self_index, std::span<const AgentMotion> all, float look_ahead_s, float max_speed_mps,
                 float max_radius_m)
    : all_(all),
      self_(all[self_index]),
      self_index_(static_cast<std::uint32_t>(self_index)),
      look_ahead_s_(look_ahead_s),
      max_closing_mps_(self_.speed + max_speed_mps),
      touch_m_(self_.radius + max_radius_m) {}

float Lookout::range_m() const {
  if (touching_) return touch_m_;
  const float seconds = meeting_ ? meeting_->in_s : look_ahead_s_;
  // The distance that both can cover in that time, plus the width of their bodies.
  return std::max(touch_m_, max_closing_mps_ * seconds + 2 * self_.radius);
}

void Lookout::Look(std::uint32_t index) {
  const AgentMotion& other = all_[index];
  if (index == self_index_ || !other.alive) return;
  if (Distance(self_.position, other.position) < self_.radius + other.radius && PushFrom(other) != Vec3{}) {
    touching_ = std::min(touching_.value_or(index), index);
    return;
  }
  if (touching_) return;
  const std::optional<float> in_s = MeetsIn(other);
  if (!in_s) return;
  const bool is_sooner = !meeting_ || *in_s < meeting_->in_s || (*in_s == meeting_->in_s && index < meeting_->index);
  if (is_sooner) meeting_ = Meeting{index, *in_s};
}

Vec3 Lookout::PushFrom(const AgentMotion& other) const {
  const Vec3 off = self_.position - other.position;
  return off - self_.forward * Dot(off, self_.forward);
}

std::optional<float> Lookout::MeetsIn(const AgentMotion& other) const {
  const Vec3 drift = other.velocity - self_.velocity;
  const float drift_mps = Length(drift);
  float in_s = 0;
  if (drift_mps > 0) in_s = Dot(drift * (1 / drift_mps), self_.position - other.position) / drift_mps;
  if (!(in_s >= 0) || in_s >= look_ahead_s_) return std::nullopt;
  if (Distance(PlaceIn(self_, in_s), PlaceIn(other, in_s)) >= 2 * self_.radius) return std::nullopt;
  return in_s;
}

float Lookout::SideFor(const AgentMotion& other, float in_s) const {
  const float agreement = Dot(self_.forward, other.forward);
  const auto away_from = [&](float to_its_left) { return to_its_left > 0 ? -1.0f : 1.0f; };
  const bool along = agreement > kAlongEachOther || agreement < -kAlongEachOther;
  // Parallel paths: step away from the side on which the other is, or will be when they pass. Crossing paths: pass
  // behind the other; only the faster agent has to.
  if (!along) return other.speed <= self_.speed ? away_from(Dot(self_.left, other.velocity)) : 0;
  const Vec3 place = agreement > 0 ? other.position : PlaceIn(other, in_s);
  return away_from(Dot(place - self_.position, self_.left));
}

Vec3 Lookout::Force() const {
  if (touching_) return PushFrom(all_[*touching_]);
  if (!meeting_) return {};
  return self_.left * SideFor(all_[meeting_->index], meeting_->in_s);
}

}  // namespace soarbox::world
