// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/soldier_skeleton.h"

#include <cmath>

namespace soarbox::world {
namespace {

using Size = SoldierSize;

constexpr float kArmOut_rad = 0.62f;

/// The rotation with the y axis along -direction and the z axis towards `palm`.
Quat HandFrame(Vec3 direction, Vec3 palm) {
  const Vec3 y = -Normalized(direction);
  const Vec3 x = Normalized(Cross(y, palm));
  return FromAxes(x, y, Cross(x, y));
}

/// Palms face the body.
Quat BindHandFrame(float side) {
  return HandFrame(BindArmDirection(side), {-side, 0, 0});
}

RifleHold MakeHold() {
  RifleHold hold;
  const Quat attached = FromRotationVector(RifleHold::kAttachRotation_deg);
  // The script attaches the rifle to the hand at this position, so the wrist is at this position in the rifle.
  hold.right_hand = Conjugate(attached);
  hold.right_wrist = -Rotate(Conjugate(attached), RifleHold::kAttachOffset);
  hold.grip = hold.right_wrist + Vec3{0.078f, -0.022f, -0.014f};
  // From below and from the left, with the palm up against the handguard.
  const Vec3 direction = Normalized(Vec3{0.62f, 0.30f, 0.72f}), palm{0.0f, 0.95f, 0.3f};
  hold.left_hand = LeftHandTurn(direction, palm);
  hold.left_wrist = hold.grip + Vec3{0.245f, 0.012f, 0} - direction * 0.085f;
  return hold;
}

Skeleton MakeSkeleton() {
  Skeleton skeleton;
  skeleton.Add("b_Hips", -1, {{0, Size::kHips, 0}, {}});
  skeleton.Add("b_Spine", kHips, {{0, Size::kSpine, -0.005f}, {}});
  skeleton.Add("b_Chest", kSpine, {{0, Size::kChest, -0.005f}, {}});
  skeleton.Add("b_Neck", kChest, {{0, Size::kNeck, -0.012f}, {}});
  // The head looks along -z of its bone, as the sandbox's scripts expect.
  skeleton.Add("b_Head1", kNeck, {{0, Size::kHead, 0.005f}, Turn({0, 1, 0}, 3.14159265f)});
  for (const float side : {1.0f, -1.0f}) {
    const std::string name = side > 0 ? "b_Left" : "b_Right";
    const int clavicle = skeleton.Add(name + "Clavicle", kChest, {{side * 0.03f, Size::kShoulder + 0.015f, 0.01f}, {}});
    const Vec3 shoulder{side * Size::kShoulderSide, Size::kShoulder, -0.01f};
    const Vec3 elbow = shoulder + BindArmDirection(side) * Size::kUpperArm;
    const Vec3 wrist = elbow + BindArmDirection(side) * Size::kForearm;
    const int arm = skeleton.Add(name + "Arm", clavicle, {shoulder, {}});
    const int forearm = skeleton.Add(name + "Forearm", arm, {elbow, {}});
    Quat hand;
    if (side < 0) {
      // Chosen so that fingers that hold the rifle point along the arm here.
      const Quat held = HandFrame({1, 0.08f, 0.0f}, {0, 0, -1});
      hand = BindHandFrame(side) * Conjugate(held) * HoldOfRifle().right_hand;
    }
    skeleton.Add(name + "Hand", forearm, {wrist, hand});
  }
  for (const float side : {1.0f, -1.0f}) {
    const std::string name = side > 0 ? "b_Left" : "b_Right";
    const float x = side * Size::kHipSide;
    const int thigh = skeleton.Add(name + "Thigh", kHips, {{x, Size::kHipHeight, 0}, {}});
    const int shin = skeleton.Add(name + "Shin", thigh, {{x, Size::kHipHeight - Size::kThigh, 0}, {}});
    const int foot = skeleton.Add(name + "Foot", shin, {{x, Size::kAnkle, 0}, {}});
    skeleton.Add(name + "Toe", foot, {{x, 0.02f, Size::kBall}, {}});
  }
  return skeleton;
}

}  // namespace

Vec3 BindArmDirection(float side) {
  return {side * std::sin(kArmOut_rad), -std::cos(kArmOut_rad), 0};
}

Quat LeftHandTurn(Vec3 direction, Vec3 palm) {
  return HandFrame(direction, palm) * Conjugate(BindHandFrame(1));
}

Quat RightHandTurn(Vec3 direction, Vec3 palm) {
  return HandFrame(direction, palm) * Conjugate(BindHandFrame(-1)) *
         SoldierSkeleton().BindInModel(kRightHand).orientation;
}

const RifleHold& HoldOfRifle() {
  static const RifleHold hold = MakeHold();
  return hold;
}

const Skeleton& SoldierSkeleton() {
  static const Skeleton skeleton = MakeSkeleton();
  return skeleton;
}

}  // namespace soarbox::world
