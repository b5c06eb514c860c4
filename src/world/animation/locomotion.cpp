// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/locomotion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/animation/rig.h"
#include "world/state_hash.h"

namespace soarbox::world {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kSmoothing_s = 0.12f;   ///< Time constant of the smoothed speeds.
constexpr float kStanding_mps = 0.08f;  ///< Slower speeds count as standing.
constexpr float kDyingBlend_s = 0.2f;
constexpr float kStyleBlend_s = 0.25f;
constexpr float kFullTurn_rad_s = 2.0f;  ///< Turn rate at which the turning animation has full weight.
constexpr float kMostCadence = 2.6f;     ///< Maximum cycles per second; faster legs would only blur.

float Towards(float from, float to, float share) {
  return from + (to - from) * share;
}

}  // namespace

void Locomotion::Add(int clip, float weight, bool in_phase) {
  if (clip < 0 || weight <= 0) return;
  const auto index = static_cast<std::size_t>(clip);
  const float length = rig_->clips[index].length_s();
  shares_.push_back({index, in_phase ? phase_ * length : std::fmod(idle_s_, length), weight});
}

void Locomotion::AddGaits(const Rig& rig, std::span<const int> gaits, int idle, float speed_mps, float weight) {
  if (weight <= 0 || gaits.empty()) return;
  // Blends the two gaits around this speed. Standing is the gait of speed 0.
  int below = idle, above = gaits.back();
  float low = 0, high = rig.clips[static_cast<std::size_t>(above)].speed_mps();
  for (const int gait : gaits) {
    const float speed = rig.clips[static_cast<std::size_t>(gait)].speed_mps();
    if (speed <= speed_mps) {
      below = gait;
      low = speed;
    } else {
      above = gait;
      high = speed;
      break;
    }
  }
  const float share = above == below ? 1.0f : std::clamp((speed_mps - low) / std::max(high - low, 0.01f), 0.0f, 1.0f);
  Add(below, weight * (1 - share), below != idle);
  Add(above, weight * share, true);
}

void Locomotion::AddStanding(const Rig&, const Gaits& gaits, float weight, float turn_left_rad_s) {
  const int turn = turn_left_rad_s > 0 ? gaits.turn_left : gaits.turn_right;
  const float stepping = turn < 0 ? 0 : std::clamp(std::abs(turn_left_rad_s) / kFullTurn_rad_s - 0.15f, 0.0f, 1.0f);
  Add(gaits.idle, weight * (1 - stepping), false);
  if (turn < 0 || stepping <= 0 || weight <= 0) return;
  const auto index = static_cast<std::size_t>(turn);
  shares_.push_back({index, std::fmod(turn_s_, rig_->clips[index].length_s()), weight * stepping});
}

void Locomotion::Update(const Rig& rig, const BodyMotion& motion, float seconds) {
  rig_ = &rig;
  shares_.clear();
  // Changes gradually to the requested style.
  float others = 0;
  for (std::size_t i = 0; i < kLocomotionStyles; ++i) {
    if (i == static_cast<std::size_t>(style_)) continue;
    style_weights_[i] = has_heading_ ? std::max(0.0f, style_weights_[i] - seconds / kStyleBlend_s) : 0.0f;
    others += style_weights_[i];
  }
  style_weights_[static_cast<std::size_t>(style_)] = std::max(0.0f, 1 - others);
  const float nearer = 1 - std::exp(-seconds / kSmoothing_s);
  velocity_ = {Towards(velocity_.x, motion.left_mps, nearer), 0, Towards(velocity_.z, motion.forward_mps, nearer)};
  const float turned = has_heading_ ? std::remainder(motion.heading_rad - heading_, 2 * kPi) : 0.0f;
  heading_ = motion.heading_rad;
  has_heading_ = true;
  turning_ = Towards(turning_, turned / std::max(seconds, 1e-3f), nearer);
  idle_s_ = std::fmod(idle_s_ + seconds, 600.0f);
  turn_s_ = std::fmod(turn_s_ + seconds, 600.0f);
  const float speed = Length(velocity_);
  const float sideways = std::abs(velocity_.x) / std::max(std::abs(velocity_.x) + std::abs(velocity_.z), 1e-4f);
  const float moving = std::clamp(speed / kStanding_mps, 0.0f, 1.0f);

  for (std::size_t i = 0; i < kLocomotionStyles; ++i) {
    const float weight = style_weights_[i];
    if (weight <= 0) continue;
    const Gaits& gaits = rig.gaits->styles[i];
    AddStanding(rig, gaits, weight * (1 - moving), turning_);
    AddGaits(rig, velocity_.z >= 0 ? gaits.forward : gaits.backward, gaits.idle, speed,
             weight * moving * (1 - sideways));
    const int side = velocity_.x > 0 ? gaits.left : gaits.right;
    if (side >= 0 && sideways > 0) AddGaits(rig, std::span(&side, 1), gaits.idle, speed, weight * moving * sideways);
  }
  legs_ = std::clamp(speed, 0.0f, 1.0f);

  float stride = 0, weight = 0;
  for (const Share& share : shares_) {
    stride += share.weight * rig.clips[share.clip].stride_m();
    weight += share.weight;
  }
  stride /= std::max(weight, 1e-4f);
  if (stride > 1e-3f && speed > 0) {
    phase_ += std::min(speed / stride, kMostCadence) * seconds;
    phase_ -= std::floor(phase_);
  }
  // Updates the times to the new phase.
  for (Share& share : shares_) {
    const Clip& clip = rig.clips[share.clip];
    if (clip.speed_mps() > 0) share.time_s = phase_ * clip.length_s();
  }

  if (motion.alive) {
    death_s_ = -1;
    return;
  }
  death_s_ = death_s_ < 0 ? 0 : death_s_ + seconds;
  if (rig.gaits->die < 0) return;
  const auto index = static_cast<std::size_t>(rig.gaits->die);
  const float dying = std::clamp(death_s_ / kDyingBlend_s, 0.0f, 1.0f);
  for (Share& share : shares_) share.weight *= 1 - dying;
  shares_.push_back({index, std::min(death_s_, rig.clips[index].length_s()), dying});
}

void Locomotion::AddTo(StateHash& hash) const {
  hash.Add(static_cast<std::uint64_t>(style_));
  for (const float weight : style_weights_) hash.Add(weight);
  hash.Add(phase_);
  hash.Add(idle_s_);
  hash.Add(death_s_);
  hash.Add(velocity_);
  hash.Add(turning_);
  hash.Add(heading_);
}

}  // namespace soarbox::world
