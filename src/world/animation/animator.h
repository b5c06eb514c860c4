// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/animation/locomotion.h"
#include "world/animation/pose.h"
#include "world/animation/rig.h"

namespace soarbox::world {

class StateHash;

/// The state of one animation of a body, as scripts set it.
struct AnimationState {
  bool enabled = false;
  bool looping = true;
  float time_s = 0;
  float weight = 1;
  bool plays = false;    ///< Advance advances it: it was started by Play.
  float speed = 1;       ///< Factor of its time while it plays; negative: backwards.
  float fade_per_s = 0;  ///< Change of its weight while it plays; it is switched off at 0.
};

/// Plays the animations of one body: blends the enabled ones by weight, and computes the pose of the bones.
///
/// If the weights of the enabled animations add up to more than 1, they are divided by the sum. If they add up to less,
/// the rest is the walk (Locomotion) if that is on, else the bind pose. An animator belongs to one world and its
/// thread.
class Animator {
 public:
  explicit Animator(const Rig& rig);

  const Rig& rig() const { return *rig_; }
  const AnimationState& state(std::size_t clip) const { return states_[clip]; }

  /// With looping, the time wraps around; otherwise it is clamped to the length.
  void SetTime(std::size_t clip, float time_s);
  void SetWeight(std::size_t clip, float weight);
  void SetEnabled(std::size_t clip, bool enabled);
  void SetLooping(std::size_t clip, bool looping);

  /// Plays an animation from its start (from its end if the speed is negative), and fades out the others that play. If
  /// it plays already and has not ended, it continues with the new settings. An animation that does not loop keeps its
  /// last pose. Without a clip, all are faded out.
  void Play(std::optional<std::size_t> clip, bool loops, float speed, float blend_s);

  void set_shows_skeleton(bool shows) {
    shows_skeleton_ = shows;
    ++changes_;
  }
  bool shows_skeleton() const { return shows_skeleton_; }

  /// Switches automatic walking on or off.
  void SetLocomotion(bool enabled, LocomotionStyle style);
  bool has_locomotion() const { return has_locomotion_; }
  /// Advances the animations that play, and the walk if it is on. Call it once per tick. `motion`: null if the body
  /// belongs to no agent; then the walk does not advance.
  void Advance(const BodyMotion* motion, float seconds);

  /// The present pose. The positions of the bones are computed from it.
  Pose NowPose() const;
  /// Incremented when the pose or its display may have changed; never 0.
  std::uint64_t changes() const { return changes_; }

  /// Not const, because it caches a part of the hash. Call it on the world's thread.
  void AddTo(StateHash& hash);

 private:
  void Changed() { ++changes_; }
  void StateChanged() {
    Changed();
    is_hashed_ = false;
  }
  void Switch(AnimationState& state, bool enabled);
  void MoveTo(std::size_t clip, float time_s);
  void AdvancePlayed(float seconds);
  void FadeOut(AnimationState& state, float blend_s);

  const Rig* rig_;
  std::vector<AnimationState> states_;
  Locomotion locomotion_;
  bool plays_ = false;  ///< An animation may play.
  bool has_locomotion_ = false;
  bool shows_skeleton_ = false;
  std::uint64_t changes_ = 1;
  std::size_t enabled_ = 0;  ///< Number of states that are enabled.
  // Scripts seldom set the states, so their hash is cached.
  bool is_hashed_ = false;
  std::uint64_t hash_of_states_ = 0;
};

}  // namespace soarbox::world
