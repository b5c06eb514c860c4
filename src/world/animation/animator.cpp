// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/animator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "world/state_hash.h"

namespace soarbox::world {

Animator::Animator(const Rig& rig) : rig_(&rig), states_(rig.clips.size()) {}

void Animator::SetTime(std::size_t clip, float time_s) {
  AnimationState& state = states_[clip];
  const float length = rig_->clips[clip].length_s();
  if (state.looping) {
    state.time_s = std::fmod(time_s, length);
    if (state.time_s < 0) state.time_s += length;
  } else {
    state.time_s = std::clamp(time_s, 0.0f, length);
  }
  StateChanged();
}

void Animator::SetWeight(std::size_t clip, float weight) {
  states_[clip].weight = weight;
  StateChanged();
}

void Animator::SetEnabled(std::size_t clip, bool enabled) {
  enabled_ = enabled_ + (enabled ? 1 : 0) - (states_[clip].enabled ? 1 : 0);
  states_[clip].enabled = enabled;
  StateChanged();
}

void Animator::SetLooping(std::size_t clip, bool looping) {
  states_[clip].looping = looping;
  is_hashed_ = false;
}

void Animator::SetLocomotion(bool enabled, LocomotionStyle style) {
  has_locomotion_ = enabled && rig_->gaits != nullptr;
  locomotion_.SetStyle(style);
  Changed();
}

void Animator::Walk(const BodyMotion& motion, float seconds) {
  if (!has_locomotion_) return;
  locomotion_.Update(*rig_, motion, seconds);
  Changed();
}

Pose Animator::NowPose() const {
  Pose pose;
  pose.rig = rig_;
  pose.parts.reserve(enabled_ + (has_locomotion_ ? locomotion_.shares().size() : 0));
  for (std::uint32_t i = 0; enabled_ > 0 && i < states_.size(); ++i) {
    // Weights that are negative or not finite have no effect.
    if (states_[i].enabled && states_[i].weight > 0 && std::isfinite(states_[i].weight))
      pose.parts.push_back({i, states_[i].time_s, states_[i].weight});
  }
  pose.played = pose.parts.size();
  if (!has_locomotion_) return pose;
  pose.legs = locomotion_.legs();
  for (const Locomotion::Share& share : locomotion_.shares())
    pose.parts.push_back({static_cast<std::uint32_t>(share.clip), share.time_s, share.weight});
  return pose;
}

void Animator::AddTo(StateHash& hash) {
  if (!std::exchange(is_hashed_, true)) {
    StateHash states;
    for (const AnimationState& state : states_) {
      states.Add(static_cast<std::uint64_t>(state.enabled) * 2 + static_cast<std::uint64_t>(state.looping));
      states.Add(state.time_s, state.weight);
    }
    hash_of_states_ = states.value();
  }
  hash.Add(hash_of_states_);
  hash.Add(static_cast<std::uint64_t>(has_locomotion_));
  locomotion_.AddTo(hash);
}

}  // namespace soarbox::world
