// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "world/math.h"

namespace soarbox::world {

struct Rig;
class StateHash;

/// How a body carries itself while it walks.
enum class LocomotionStyle : std::uint8_t { kReady, kAim, kCrouch, kUnarmed };
inline constexpr std::size_t kLocomotionStyles = 4;

/// The movements of one style, by index of clip. Forward gaits are in ascending order of speed.
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

/// How a body moves, in its own directions.
struct BodyMotion {
  float forward_mps = 0;
  float left_mps = 0;
  float heading_rad = 0;  ///< Where it faces, about the upright axis.
  bool alive = true;
};

/// Walks by itself: chooses movements, their weights and their times by how fast and in which direction the body moves,
/// so that feet stay where they are set down. The cadence is the speed over the mean stride of what is mixed; all gaits
/// share one phase.
class Locomotion {
 public:
  struct Share {
    std::size_t clip;
    float time_s;
    float weight;
  };

  /// From the next Update on; what it did before fades out within a quarter of a second.
  void SetStyle(LocomotionStyle style) { style_ = style; }
  void Update(const Rig& rig, const BodyMotion& motion, float seconds);
  /// The movements to mix; weights add up to 1 after the first Update.
  const std::vector<Share>& shares() const { return shares_; }
  /// How much the legs belong to walking, 0..1: a movement of the upper body alone leaves them this much.
  float legs() const { return legs_; }

  void AddTo(StateHash& hash) const;

 private:
  void AddStanding(const Rig& rig, const Gaits& gaits, float weight, float turn_left_rad_s);
  void AddGaits(const Rig& rig, const std::vector<int>& gaits, int idle, float speed_mps, float weight);
  void Add(int clip, float weight, bool in_phase);

  LocomotionStyle style_ = LocomotionStyle::kReady;
  std::array<float, kLocomotionStyles> style_weights_{};  ///< They add up to 1 after the first Update.
  float phase_ = 0;                                       ///< 0..1, of the gaits' cycle.
  float idle_s_ = 0;                                      ///< Time of the idle movement.
  float turn_s_ = 0;                                      ///< Time of the turn.
  float death_s_ = -1;                                    ///< Since it died; -1: alive.
  Vec3 velocity_;                                         ///< Smoothed: x left, z forward.
  float turning_ = 0;                                     ///< To the left, rad/s, smoothed.
  float heading_ = 0;
  bool has_heading_ = false;
  float legs_ = 0;
  std::vector<Share> shares_;
  const Rig* rig_ = nullptr;
};

}  // namespace soarbox::world
