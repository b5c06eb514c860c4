// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/animator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "world/state_hash.h"

namespace soarbox::world {

Animator::Animator(const Rig& rig) : rig_(&rig), states_(rig.clips.size()) {}

void Animator::SetTime(std::size_t clip, float time_s) {
  MoveTo(clip, time_s);
  StateChanged();
}

void Animator::MoveTo(std::size_t clip, float time_s) {
  AnimationState& state = states_[clip];
  const float length = rig_->clips[clip].length_s();
  if (state.looping) {
    state.time_s = std::fmod(time_s, length);
    if (state.time_s < 0) state.time_s += length;
  } else {
    state.time_s = std::clamp(time_s, 0.0f, length);
  }
}

void Animator::SetWeight(std::size_t clip, float weight) {
  states_[clip].weight = weight;
  states_[clip].fade_per_s = 0;
  StateChanged();
}

void Animator::SetEnabled(std::size_t clip, bool enabled) {
  Switch(states_[clip], enabled);
  StateChanged();
}

void Animator::Switch(AnimationState& state, bool enabled) {
  enabled_ = enabled_ + (enabled ? 1 : 0) - (state.enabled ? 1 : 0);
  state.enabled = enabled;
  if (enabled) return;
  state.plays = false;
  // A fade that was interrupted leaves no weight behind.
  if (std::exchange(state.fade_per_s, 0.0f) != 0) state.weight = 1;
}

void Animator::SetLooping(std::size_t clip, bool looping) {
  states_[clip].looping = looping;
  is_hashed_ = false;
}

void Animator::FadeOut(AnimationState& state, float blend_s) {
  if (!state.plays) return;
  if (blend_s > 0) {
    state.fade_per_s = -1 / blend_s;
  } else {
    Switch(state, false);
    state.weight = 1;
  }
}

void Animator::Play(std::optional<std::size_t> clip, bool loops, float speed, float blend_s) {
  for (std::size_t other = 0; other < states_.size(); ++other)
    if (other != clip) FadeOut(states_[other], blend_s);
  StateChanged();
  if (!clip) return;
  AnimationState& state = states_[*clip];
  const float length = rig_->clips[*clip].length_s();
  const bool has_ended = !state.looping && (state.speed < 0 ? state.time_s <= 0 : state.time_s >= length);
  if (!state.enabled) state.weight = blend_s > 0 ? 0.0f : 1.0f;
  if (!state.plays || has_ended) state.time_s = speed < 0 ? length : 0;
  Switch(state, true);
  state.plays = plays_ = true;
  state.looping = loops;
  state.speed = speed;
  state.fade_per_s = blend_s > 0 ? 1 / blend_s : 0;
  if (blend_s <= 0) state.weight = 1;
}

void Animator::AdvancePlayed(float seconds) {
  if (!plays_) return;
  plays_ = false;
  for (std::size_t clip = 0; clip < states_.size(); ++clip) {
    AnimationState& state = states_[clip];
    if (!state.plays) continue;
    plays_ = true;
    const float time_s = state.time_s, weight = state.weight;
    MoveTo(clip, time_s + state.speed * seconds);
    if (state.fade_per_s != 0) {
      state.weight += state.fade_per_s * seconds;
      if (state.weight <= 0) Switch(state, false);
      if (state.fade_per_s > 0 && state.weight >= 1) {
        state.weight = 1;
        state.fade_per_s = 0;
      }
    }
    is_hashed_ = false;
    if (state.time_s != time_s || state.weight != weight) Changed();
  }
}

void Animator::SetLocomotion(bool enabled, LocomotionStyle style) {
  has_locomotion_ = enabled && rig_->gaits != nullptr;
  locomotion_.SetStyle(style);
  Changed();
}

void Animator::Advance(const BodyMotion* motion, float seconds) {
  AdvancePlayed(seconds);
  if (!has_locomotion_ || motion == nullptr) return;
  locomotion_.Update(*rig_, *motion, seconds);
  Changed();
}

Pose Animator::NowPose() const {
  Pose pose;
  pose.rig = rig_;
  pose.parts.reserve(enabled_ + (has_locomotion_ ? locomotion_.shares().size() : 0));
  const std::size_t most = rig_->model.empty() ? states_.size() : Pose::kMostOfModel;
  for (std::uint32_t i = 0; enabled_ > 0 && i < states_.size() && pose.parts.size() < most; ++i) {
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
      if (state.plays) states.Add(state.speed, state.fade_per_s);
    }
    hash_of_states_ = states.value();
  }
  hash.Add(hash_of_states_);
  hash.Add(static_cast<std::uint64_t>(has_locomotion_));
  locomotion_.AddTo(hash);
}

}  // namespace soarbox::world
