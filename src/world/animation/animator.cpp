// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/animator.h"

#include <algorithm>
#include <cmath>

#include "world/state_hash.h"

namespace soarbox::world {
namespace {

/// A movement with its share in the mix.
struct Part {
  const Clip* clip;
  float time_s;
  float weight;
};

/// A sum of poses by weight.
class Mix {
 public:
  void Add(const BonePose& pose, float weight) {
    const Quat q = pose.orientation;
    const float dot = turn_.w * q.w + turn_.x * q.x + turn_.y * q.y + turn_.z * q.z;
    const float w = dot < 0 ? -weight : weight;
    turn_ = {turn_.w + w * q.w, turn_.x + w * q.x, turn_.y + w * q.y, turn_.z + w * q.z};
    place_ += pose.position * weight;
    sum_ += weight;
  }
  float sum() const { return sum_; }
  BonePose Mean() const { return {place_ / sum_, Normalized(turn_)}; }

 private:
  Quat turn_{0, 0, 0, 0};
  Vec3 place_;
  float sum_ = 0;
};

}  // namespace

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
  Changed();
}

void Animator::SetWeight(std::size_t clip, float weight) {
  states_[clip].weight = weight;
  Changed();
}

void Animator::SetEnabled(std::size_t clip, bool enabled) {
  states_[clip].enabled = enabled;
  Changed();
}

void Animator::SetLooping(std::size_t clip, bool looping) {
  states_[clip].looping = looping;
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

const std::vector<BonePose>& Animator::Bones() const {
  if (!is_current_) Evaluate();
  return bones_;
}

void Animator::Evaluate() const {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    // A weight below 0 or beyond numbers has no share.
    if (states_[i].enabled && states_[i].weight > 0 && std::isfinite(states_[i].weight))
      parts.push_back({&rig_->clips[i], states_[i].time_s, states_[i].weight});
  }
  std::vector<Part> walk;
  if (has_locomotion_) {
    for (const Locomotion::Share& share : locomotion_.shares())
      walk.push_back({&rig_->clips[share.clip], share.time_s, share.weight});
  }

  const float legs_walk = has_locomotion_ ? locomotion_.legs() : 0.0f;
  const auto& bones = rig_->skeleton.bones();
  std::vector<BonePose> local(bones.size());
  for (std::size_t i = 0; i < bones.size(); ++i) {
    Mix mix;
    const bool is_lower = !rig_->is_lower_body.empty() && rig_->is_lower_body[i];
    for (const Part& part : parts) {
      const float share = is_lower && part.clip->upper_body() ? 1 - legs_walk : 1.0f;
      if (share > 0) mix.Add(part.clip->At(i, part.time_s), part.weight * share);
    }
    const float rest = 1 - mix.sum();
    if (rest > 0) {
      Mix below;
      for (const Part& part : walk) {
        if (part.weight > 0) below.Add(part.clip->At(i, part.time_s), part.weight);
      }
      mix.Add(below.sum() > 0 ? below.Mean() : bones[i].bind, rest);
    }
    local[i] = mix.Mean();
  }
  rig_->skeleton.ToModel(local, bones_);
  is_current_ = true;
}

void Animator::AddTo(StateHash& hash) const {
  for (const AnimationState& state : states_) {
    hash.Add(static_cast<std::uint64_t>(state.enabled) * 2 + static_cast<std::uint64_t>(state.looping));
    hash.Add(state.time_s);
    hash.Add(state.weight);
  }
  hash.Add(static_cast<std::uint64_t>(has_locomotion_));
  locomotion_.AddTo(hash);
}

}  // namespace soarbox::world
