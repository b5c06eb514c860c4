// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "world/math.h"

namespace soarbox::world {

struct Rig;
class StateHash;

/// The posture of a body while it walks.
enum class LocomotionStyle : std::uint8_t { kReady, kAim, kCrouch, kUnarmed };
inline constexpr std::size_t kLocomotionStyles = 4;

/// The animations of one style, by index of clip. Forward gaits are sorted by speed.
struct Gaits {
  int idle = -1;
  std::vector<int> forward, backward;
  int left = -1, right = -1;
  int turn_left = -1, turn_right = -1;
};

struct GaitTable {
  Gaits styles[kLocomotionStyles];
  int die = -1;
};

/// The motion of a body in its own coordinates.
struct BodyMotion {
  float forward_mps = 0;
  float left_mps = 0;
  float heading_rad = 0;  ///< Direction in which it faces, about the vertical axis.
  bool alive = true;
};

/// Automatic walking: selects animations, their weights and times from the speed and direction of the body, so that
/// feet do not slide. The cadence is the speed divided by the mean stride of the blended gaits. All gaits have the same
/// phase.
class Locomotion {
 public:
  struct Share {
    std::size_t clip;
    float time_s;
    float weight;
  };

  /// Takes effect in the next Update. The previous style fades out within a quarter of a second.
  void SetStyle(LocomotionStyle style) { style_ = style; }
  void Update(const Rig& rig, const BodyMotion& motion, float seconds);
  /// The animations to blend. Weights add up to 1 after the first Update.
  const std::vector<Share>& shares() const { return shares_; }
  /// Fraction of the legs that belongs to walking, 0..1. An animation of the upper body affects the rest of them.
  float legs() const { return legs_; }

  void AddTo(StateHash& hash) const;

 private:
  void AddStanding(const Rig& rig, const Gaits& gaits, float weight, float turn_left_rad_s);
  void AddGaits(const Rig& rig, std::span<const int> gaits, int idle, float speed_mps, float weight);
  void Add(int clip, float weight, bool in_phase);

  LocomotionStyle style_ = LocomotionStyle::kReady;
  std::array<float, kLocomotionStyles> style_weights_{};  ///< They add up to 1 after the first Update.
  float phase_ = 0;                                       ///< 0..1, in the cycle of the gaits.
  float idle_s_ = 0;                                      ///< Time in the idle animation.
  float turn_s_ = 0;                                      ///< Time in the turning animation.
  float death_s_ = -1;                                    ///< Time since it died; -1 while alive.
  Vec3 velocity_;                                         ///< Smoothed: x left, z forward.
  float turning_ = 0;                                     ///< To the left, in rad/s, smoothed.
  float heading_ = 0;
  bool has_heading_ = false;
  float legs_ = 0;
  std::vector<Share> shares_;
  const Rig* rig_ = nullptr;
};

}  // namespace soarbox::world
