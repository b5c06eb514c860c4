// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/animation/skeleton.h"

namespace soarbox::world {

/// The soldier's bones, by index. Models face +z, with the left side at +x. In the bind pose the soldier stands upright
/// with straight legs and the arms a little away from the body.
enum SoldierBone : int {
  kHips,
  kSpine,
  kChest,
  kNeck,
  kHead,
  kLeftClavicle,
  kLeftArm,
  kLeftForearm,
  kLeftHand,
  kRightClavicle,
  kRightArm,
  kRightForearm,
  kRightHand,
  kLeftThigh,
  kLeftShin,
  kLeftFoot,
  kLeftToe,
  kRightThigh,
  kRightShin,
  kRightFoot,
  kRightToe,
  kSoldierBones
};

/// Lengths in m, without helmet and soles: the mesh is built around them.
struct SoldierSize {
  static constexpr float kHips = 0.925f;       ///< Height of the pelvis.
  static constexpr float kHipHeight = 0.885f;  ///< Height of the hip joints.
  static constexpr float kHipSide = 0.092f;
  static constexpr float kThigh = 0.405f, kShin = 0.395f;
  static constexpr float kAnkle = kHipHeight - kThigh - kShin;
  static constexpr float kBall = 0.125f;  ///< From the ankle forward to the ball of the foot.
  static constexpr float kHeel = 0.065f;  ///< From the ankle back to the heel.
  static constexpr float kSpine = 1.03f, kChest = 1.17f, kNeck = 1.43f, kHead = 1.515f;
  static constexpr float kShoulderSide = 0.175f, kShoulder = 1.375f;
  static constexpr float kUpperArm = 0.27f, kForearm = 0.25f;
};

/// Direction of an arm in the bind pose; side is 1 on the left, -1 on the right.
Vec3 BindArmDirection(float side);

const Skeleton& SoldierSkeleton();

/// Position and orientation of the hands that hold the rifle, in the rifle's coordinates (barrel +x, up +y). The
/// sandbox's scripts attach the rifle to the right hand with these values.
struct RifleHold {
  static constexpr Vec3 kAttachOffset{0.04f, 0.05f, -0.01f};  ///< Position of the rifle, in the coordinates of the
                                                              ///< right hand's bone.
  static constexpr Vec3 kAttachRotation_deg{98, 97, 0};
  Vec3 right_wrist;
  Vec3 left_wrist;
  Quat right_hand;  ///< Rotation of the bone relative to the rifle.
  Quat left_hand;
  Vec3 grip;  ///< The middle of the pistol grip.
};
const RifleHold& HoldOfRifle();

/// The rotation of the left hand's bone for which its fingers point along `direction` and the palm faces `palm`. It
/// takes into account how the hand lies in its bind pose.
Quat LeftHandTurn(Vec3 direction, Vec3 palm);
/// The same for the right hand: the rotation of its bone in the model.
Quat RightHandTurn(Vec3 direction, Vec3 palm);

}  // namespace soarbox::world
