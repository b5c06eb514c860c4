// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/animation/bone_pose.h"

namespace soarbox::world {

/// A pose of the soldier said in a few words: where the body, the feet and the rifle are. SolvePose works out the
/// bones. All in the model's space (facing +z, left +x), angles in radians.
struct SoldierPose {
  struct Foot {
    Vec3 ankle;
    float yaw = 0;        ///< To the left.
    float pitch = 0;      ///< Toes down.
    float toe_pitch = 0;  ///< Of the toes alone, relative to the foot.
    float roll = 0;
  };
  Vec3 hips;
  Quat hips_turn, chest_turn, head_turn;
  Foot left, right;
  Vec3 knees{0, 0, 1};      ///< Where knees point, in the hips' space.
  float knees_out = 0.12f;  ///< How far they point outwards.
  Vec3 rifle;               ///< The middle of its grip, from the middle between the shoulders, in the rifle's frame.
  Quat rifle_frame;         ///< What the rifle's place and direction are turned by.
  Vec3 barrel{0, 0, 1}, rifle_up{0, 1, 0};
  Vec3 left_elbow{0.55f, -0.9f, -0.1f}, right_elbow{-0.6f, -0.8f, -0.2f};  ///< Where elbows point.
  float left_off_rifle = 0;                                                ///< 1: the left hand is at left_wrist.
  Vec3 left_wrist;  ///< From the middle between the shoulders, in the rifle's frame.
  Vec3 left_fingers{0, 0, 1}, left_palm{0, 1, 0};
  float right_off_rifle = 0;  ///< The same for the right hand.
  Vec3 right_wrist;
  Vec3 right_fingers{0, 0, 1}, right_palm{0, 1, 0};
  float shoulders_forward = 0.12f;
};

/// Between two poses; b at share 1.
SoldierPose Between(const SoldierPose& a, const SoldierPose& b, float share);

/// The bones of a pose, relative to their parents. Arms and legs stretch towards what they cannot reach.
std::vector<BonePose> SolvePose(const SoldierPose& pose);

}  // namespace soarbox::world
