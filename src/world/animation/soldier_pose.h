// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/animation/bone_pose.h"

namespace soarbox::world {

/// A pose of the soldier described by a few parameters: position of the body, the feet and the rifle. SolvePose
/// computes the bones. All in model coordinates (facing +z, left +x), angles in radians.
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
  Vec3 knees{0, 0, 1};      ///< Direction of the knees, in the coordinates of the hips.
  float knees_out = 0.12f;  ///< Amount by which they point outwards.
  Vec3 rifle;               ///< Middle of its grip, from the middle between the shoulders, in the rifle's frame.
  Quat rifle_frame;         ///< Rotation of the rifle's frame.
  Vec3 barrel{0, 0, 1}, rifle_up{0, 1, 0};
  Vec3 left_elbow{0.55f, -0.9f, -0.1f}, right_elbow{-0.6f, -0.8f, -0.2f};  ///< Directions of the elbows.
  float left_off_rifle = 0;                                                ///< 1: the left hand is at left_wrist.
  Vec3 left_wrist;  ///< From the middle between the shoulders, in the rifle's frame.
  Vec3 left_fingers{0, 0, 1}, left_palm{0, 1, 0};
  float right_off_rifle = 0;  ///< The same for the right hand.
  Vec3 right_wrist;
  Vec3 right_fingers{0, 0, 1}, right_palm{0, 1, 0};
  float shoulders_forward = 0.12f;
};

/// Interpolates between two poses; returns b at share 1.
SoldierPose Between(const SoldierPose& a, const SoldierPose& b, float share);

/// Computes the bones of a pose, relative to their parents. Limbs that cannot reach their target are stretched towards
/// it.
std::vector<BonePose> SolvePose(const SoldierPose& pose);

}  // namespace soarbox::world
