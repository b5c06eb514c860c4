// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "world/animation/bone_pose.h"

namespace soarbox::world {

/// The values of one property of a bone at some times. Between two times, values are interpolated, or the earlier one
/// holds.
template <typename T>
struct BoneTrack {
  std::vector<float> times_s;  ///< Ascending.
  std::vector<T> values;       ///< One for each time. Empty: the property has its value of the bind pose.
  bool holds = false;
};

/// The movement of one bone in a clip, relative to the bone's parent.
struct BoneMovement {
  BonePose bind;
  BoneTrack<Vec3> position;
  BoneTrack<Quat> orientation;
  BoneTrack<Vec3> scale;
};

/// One animation of a skeleton: the poses of all its bones at equal intervals, or a movement for each bone. Shared and
/// immutable, like the skeleton.
class Clip {
 public:
  struct Settings {
    std::string name;
    float length_s = 1;       ///< Greater than 0.
    bool is_cycle = false;    ///< Its end joins its start.
    bool upper_body = false;  ///< It leaves the legs free to walk.
    float speed_mps = 0;      ///< Speed at which the feet move the body, for gaits.
  };

  /// keys: at least two poses relative to the bones' parents; the first at 0 s, the last at length_s.
  Clip(Settings settings, std::vector<std::vector<BonePose>> keys);
  Clip(Settings settings, std::vector<BoneMovement> movements);

  const std::string& name() const { return settings_.name; }
  float length_s() const { return settings_.length_s; }
  bool is_cycle() const { return settings_.is_cycle; }
  bool upper_body() const { return settings_.upper_body; }
  float speed_mps() const { return settings_.speed_mps; }
  /// Distance that one cycle covers.
  float stride_m() const { return settings_.speed_mps * settings_.length_s; }

  /// The pose of one bone relative to its parent. The time is clamped to 0..length_s.
  BonePose At(std::size_t bone, float time_s) const;
  /// By bone; empty if the clip has poses at equal intervals.
  const std::vector<BoneMovement>& movements() const { return movements_; }

 private:
  Settings settings_;
  std::vector<std::vector<BonePose>> keys_;
  std::vector<BoneMovement> movements_;
};

}  // namespace soarbox::world
