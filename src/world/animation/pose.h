// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "world/animation/bone_pose.h"

namespace soarbox::world {

struct Rig;

/// What a body does at one moment: which animations are blended, and the time in each. The positions of its bones
/// follow from a pose. Computing them takes much longer than storing the pose.
struct Pose {
  struct Part {
    std::uint32_t clip = 0;  ///< Index in the rig; an invalid index has no effect.
    float time_s = 0;
    float weight = 0;
    friend bool operator==(const Part&, const Part&) = default;
  };
  /// Maximum number of animations that a mesh from a file blends; further ones have no effect.
  static constexpr std::size_t kMostOfModel = 16;

  const Rig* rig = nullptr;  ///< Must not be null when bones are computed.
  /// First the `played` animations of scripts, whose weights are above 0; then those of the walk.
  std::vector<Part> parts;
  std::size_t played = 0;
  float legs = 0;  ///< Fraction of the legs that belongs to the walk, 0 to 1, if an animation of the upper body plays.

  /// Computes the poses of all bones in the model, by index.
  void WorkOut(std::vector<BonePose>& bones) const;
  /// Computes the pose of one bone; needs only its ancestors.
  BonePose WorkOut(std::size_t bone) const;

 private:
  BonePose Local(std::size_t bone) const;
};

}  // namespace soarbox::world
