// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "world/animation/bone_pose.h"

namespace soarbox::world {

struct Rig;

/// What a body does at one moment: which movements are mixed, and how far each is. Where its bones are follows from
/// that, and takes much longer to work out than this takes to note.
struct Pose {
  struct Part {
    std::uint32_t clip = 0;  ///< Of the rig; one that it does not have does nothing.
    float time_s = 0;
    float weight = 0;
    friend bool operator==(const Part&, const Part&) = default;
  };
  const Rig* rig = nullptr;  ///< Never null where bones are asked for.
  /// First those that scripts play, `played` of them, whose weights are above 0; then those of the walk.
  std::vector<Part> parts;
  std::size_t played = 0;
  float legs = 0;  ///< How much of the legs is the walk's, 0 to 1, where a movement is one of the upper body.

  /// Where the bones are in the model, by index.
  void WorkOut(std::vector<BonePose>& bones) const;
  /// The same of one bone, without those that it does not hang on.
  BonePose WorkOut(std::size_t bone) const;

 private:
  BonePose Local(std::size_t bone) const;
};

}  // namespace soarbox::world
