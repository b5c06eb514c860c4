// SPDX-License-Identifier: BSD-2-Clause
#include "sim/bearing.h"

#include <algorithm>

#include "world/animation/animator.h"
#include "world/state_hash.h"
#include "world/world.h"

namespace soarbox::sim {
namespace {

using Style = world::LocomotionStyle;

constexpr float kStaysUp_s = 1.5f;
constexpr float kFade_s = 0.12f;

}  // namespace

void Bearing::Begin(world::Animator& animator, std::string_view clip) {
  if (clip_ >= 0) animator.SetEnabled(static_cast<std::size_t>(clip_), false);
  clip_ = animator.rig().FindClip(clip);
  if (clip_ < 0) return;
  const auto index = static_cast<std::size_t>(clip_);
  animator.SetLooping(index, false);
  animator.SetTime(index, 0);
  animator.SetWeight(index, 0);
  animator.SetEnabled(index, true);
}

void Bearing::GoOn(world::Animator& animator, float seconds, bool reloads) {
  if (clip_ < 0) return;
  const auto index = static_cast<std::size_t>(clip_);
  const float length = animator.rig().clips[index].length_s();
  float time = animator.state(index).time_s + seconds;
  // If the weapon is loaded before the animation ends, the rifle is raised early.
  if (loads_ && !reloads) time = std::max(time, length - kFade_s);
  animator.SetTime(index, time);
  animator.SetWeight(index, std::clamp(std::min(time, length - time) / kFade_s, 0.0f, 1.0f));
  if (time < length) return;
  animator.SetEnabled(index, false);
  clip_ = -1;
}

void Bearing::Show(world::World& world, const Deeds& deeds) {
  world::Animator* animator = world.scene().AnimatorOf(figure_);
  if (animator == nullptr) return;
  const float step_s = world.settings().step_s;
  const bool stands = deeds.stance == "standing";
  aims_s_ = deeds.shoots ? kStaysUp_s : std::max(0.0f, aims_s_ - step_s);
  const Style upright = !deeds.is_armed ? Style::kUnarmed : aims_s_ > 0 ? Style::kAim : Style::kReady;
  const Style style = stands ? upright : Style::kCrouch;
  if (style != style_ || !is_shown_) animator->SetLocomotion(true, style);
  style_ = style;
  if (is_shown_ && deeds.is_armed) {
    if (deeds.reloads && !last_.reloads) {
      Begin(*animator, stands ? "stand_reload" : "crouch_reload");
      loads_ = true;
    } else if (deeds.rounds < last_.rounds && !deeds.reloads) {
      Begin(*animator, stands ? "stand_fire_one_shot" : "crouch_fire_one_shot");
      loads_ = false;
    } else if (deeds.health < last_.health && clip_ < 0) {
      Begin(*animator, stands ? "stand_hit" : "crouch_hit");
      loads_ = false;
    }
  }
  GoOn(*animator, step_s, deeds.reloads);
  is_shown_ = true;
  last_ = deeds;
  last_.stance = {};
}

void Bearing::End(world::World& world) {
  world::Animator* animator = world.scene().AnimatorOf(figure_);
  if (animator != nullptr && clip_ >= 0) animator->SetEnabled(static_cast<std::size_t>(clip_), false);
  clip_ = -1;
}

void Bearing::AddTo(world::StateHash& hash) const {
  hash.Add(aims_s_);
  hash.Add(static_cast<std::uint64_t>(clip_ + 1));
}

}  // namespace soarbox::sim
