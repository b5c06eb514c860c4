// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "world/animation/locomotion.h"
#include "world/animation/pose.h"
#include "world/animation/rig.h"

namespace soarbox::world {

class StateHash;

/// One movement of one body, as scripts set it.
struct AnimationState {
  bool enabled = false;
  bool looping = true;
  float time_s = 0;
  float weight = 1;
};

/// Plays the movements of one body: mixes what is enabled by weight, and says where the bones are.
///
/// Weights of all enabled movements are divided by their sum if that is above 1; below 1 the rest goes to the walk
/// (Locomotion) if that is switched on, else to the bind pose. A body belongs to one world and its thread.
class Animator {
 public:
  explicit Animator(const Rig& rig);

  const Rig& rig() const { return *rig_; }
  const AnimationState& state(std::size_t clip) const { return states_[clip]; }

  /// Looping: the time wraps around; otherwise it is held within the length.
  void SetTime(std::size_t clip, float time_s);
  void Step(std::size_t clip, float seconds) { SetTime(clip, states_[clip].time_s + seconds); }
  void SetWeight(std::size_t clip, float weight);
  void SetEnabled(std::size_t clip, bool enabled);
  void SetLooping(std::size_t clip, bool looping);

  void set_shows_skeleton(bool shows) {
    shows_skeleton_ = shows;
    ++changes_;
  }
  bool shows_skeleton() const { return shows_skeleton_; }

  /// Switches walking by itself on (or off).
  void SetLocomotion(bool enabled, LocomotionStyle style);
  bool has_locomotion() const { return has_locomotion_; }
  /// Once per tick.
  void Walk(const BodyMotion& motion, float seconds);

  /// What it does now; where its bones are follows from that.
  Pose NowPose() const;
  /// Grows whenever the pose, or what is shown of it, may have changed; never 0.
  std::uint64_t changes() const { return changes_; }

  void AddTo(StateHash& hash) const;

 private:
  void Changed() { ++changes_; }

  const Rig* rig_;
  std::vector<AnimationState> states_;
  Locomotion locomotion_;
  bool has_locomotion_ = false;
  bool shows_skeleton_ = false;
  std::uint64_t changes_ = 1;
};

}  // namespace soarbox::world
