// SPDX-License-Identifier: BSD-2-Clause
#include "world/animation/soldier_pose.h"

#include <algorithm>
#include <cmath>

#include "world/animation/soldier_skeleton.h"

namespace soarbox::world {
namespace {

using Size = SoldierSize;

/// Two bones from a root to a target, bent towards a pole vector.
struct Limb {
  Quat upper, lower;
  Vec3 joint, end;
};

/// The rotation of a bone that points from `from` to `to` and bends about `hinge`.
Quat BoneTurn(Vec3 from, Vec3 to, Vec3 hinge) {
  const Vec3 y = Normalized(from - to);
  const Vec3 z = Normalized(Cross(hinge, y));
  return FromAxes(Cross(y, z), y, z);
}

Limb Reach(Vec3 root, Vec3 target, float upper_m, float lower_m, Vec3 pole) {
  const Vec3 way = target - root;
  const float length = std::clamp(Length(way), std::abs(upper_m - lower_m) + 0.02f, 0.995f * (upper_m + lower_m));
  const Vec3 direction = LengthSquared(way) > 0 ? Normalized(way) : Vec3{0, -1, 0};
  const float cosine =
      std::clamp((upper_m * upper_m + length * length - lower_m * lower_m) / (2 * upper_m * length), -1.0f, 1.0f);
  Vec3 side = pole - direction * Dot(pole, direction);
  side = LengthSquared(side) > 1e-6f ? Normalized(side) : Normalized(Cross(direction, {1, 0, 0}));
  Limb limb;
  limb.joint = root + direction * (upper_m * cosine) + side * (upper_m * std::sqrt(1 - cosine * cosine));
  limb.end = root + direction * length;
  const Vec3 hinge = Normalized(Cross(-direction, side));
  limb.upper = BoneTurn(root, limb.joint, hinge);
  limb.lower = BoneTurn(limb.joint, limb.end, hinge);
  return limb;
}

/// The component of a rotation about an axis.
float TwistAbout(Quat turn, Vec3 axis) {
  return 2 * std::atan2(turn.x * axis.x + turn.y * axis.y + turn.z * axis.z, turn.w);
}

class Solver {
 public:
  explicit Solver(const SoldierPose& pose) : pose_(pose), skeleton_(SoldierSkeleton()), model_(kSoldierBones) {}

  std::vector<BonePose> Solve() {
    Trunk();
    Arms();
    Leg(kLeftThigh, pose_.left, 1);
    Leg(kRightThigh, pose_.right, -1);
    // A falling body stays above the ground.
    constexpr float kLowest_m = -0.02f;
    float lowest = 0;
    for (const BonePose& bone : model_) lowest = std::min(lowest, bone.position.y);
    if (lowest < kLowest_m) {
      for (BonePose& bone : model_) bone.position.y += kLowest_m - lowest;
    }
    std::vector<BonePose> local(kSoldierBones);
    for (int i = 0; i < kSoldierBones; ++i) {
      const int parent = skeleton_.bones()[static_cast<std::size_t>(i)].parent;
      local[static_cast<std::size_t>(i)] = parent < 0 ? At(i) : Inverse(At(parent)) * At(i);
    }
    return local;
  }

 private:
  BonePose& At(int bone) { return model_[static_cast<std::size_t>(bone)]; }

  /// Attaches a bone to its parent; `turn` is its rotation in the model relative to its bind pose.
  void Hang(int bone, Quat turn) {
    const Skeleton::Bone& known = skeleton_.bones()[static_cast<std::size_t>(bone)];
    At(bone) = {At(known.parent).Apply(known.bind.position), turn * skeleton_.BindInModel(bone).orientation};
  }

  void Trunk() {
    At(kHips) = {pose_.hips, pose_.hips_turn};
    Hang(kSpine, Between(pose_.hips_turn, pose_.chest_turn, 0.5f));
    Hang(kChest, pose_.chest_turn);
    Hang(kNeck, Between(pose_.chest_turn, pose_.head_turn, 0.5f));
    Hang(kHead, pose_.head_turn);
    const float forward = pose_.shoulders_forward;
    Hang(kLeftClavicle, pose_.chest_turn * Turn({0, 1, 0}, -forward));
    Hang(kRightClavicle, pose_.chest_turn * Turn({0, 1, 0}, forward));
  }

  void Arm(int arm, Vec3 wrist, Quat hand, Vec3 pole, float side) {
    Hang(arm, {});
    const Vec3 shoulder = At(arm).position;
    const Limb limb = Reach(shoulder, wrist, Size::kUpperArm, Size::kForearm, pole);
    // In the bind pose, elbows point backwards.
    const Vec3 bind_way = BindArmDirection(side);
    const Vec3 bind_hinge = Normalized(Cross(-bind_way, {0, 0, -1}));
    const Quat bind = BoneTurn({}, bind_way, bind_hinge);
    Hang(arm, limb.upper * Conjugate(bind));
    Hang(arm + 1, limb.lower * Conjugate(bind));
    // The forearm gets half of the hand's twist.
    const int hand_bone = arm + 2;
    const Quat forearm = limb.lower * Conjugate(bind);
    const Quat relative = Conjugate(forearm) * hand * Conjugate(skeleton_.BindInModel(hand_bone).orientation);
    float twist = TwistAbout(relative, bind_way);
    constexpr float kPi = 3.14159265f;
    if (twist > kPi) twist -= 2 * kPi;
    if (twist < -kPi) twist += 2 * kPi;
    Hang(arm + 1, forearm * Turn(bind_way, 0.5f * twist));
    At(hand_bone) = {limb.end, hand};
  }

  void Arms() {
    Hang(kLeftArm, {});
    Hang(kRightArm, {});
    const Vec3 shoulders = (At(kLeftArm).position + At(kRightArm).position) / 2;
    const RifleHold& hold = HoldOfRifle();
    const Vec3 x = Rotate(pose_.rifle_frame, Normalized(pose_.barrel));
    Vec3 y = Rotate(pose_.rifle_frame, pose_.rifle_up);
    y = Normalized(y - x * Dot(x, y));
    const BonePose rifle_turn{{}, FromAxes(x, y, Cross(x, y))};
    const Vec3 grip = shoulders + Rotate(pose_.rifle_frame, pose_.rifle);
    const BonePose rifle{grip - rifle_turn.Apply(hold.grip), rifle_turn.orientation};
    const Quat frame = pose_.rifle_frame;
    Vec3 right_wrist = rifle.Apply(hold.right_wrist);
    Quat right_hand = rifle.orientation * hold.right_hand;
    if (pose_.right_off_rifle > 0) {
      const Quat free = frame * RightHandTurn(pose_.right_fingers, pose_.right_palm);
      right_wrist = Between(right_wrist, shoulders + Rotate(frame, pose_.right_wrist), pose_.right_off_rifle);
      right_hand = Between(right_hand, free, pose_.right_off_rifle);
    }
    Arm(kRightArm, right_wrist, right_hand, Rotate(frame, pose_.right_elbow), -1);
    Vec3 left_wrist = rifle.Apply(hold.left_wrist);
    Quat left_hand = rifle.orientation * hold.left_hand;
    if (pose_.left_off_rifle > 0) {
      const Quat free = frame * LeftHandTurn(pose_.left_fingers, pose_.left_palm);
      left_wrist = Between(left_wrist, shoulders + Rotate(frame, pose_.left_wrist), pose_.left_off_rifle);
      left_hand = Between(left_hand, free, pose_.left_off_rifle);
    }
    Arm(kLeftArm, left_wrist, left_hand, Rotate(frame, pose_.left_elbow), 1);
  }

  void Leg(int thigh, const SoldierPose::Foot& foot, float side) {
    Hang(thigh, {});
    const Quat yaw = Turn({0, 1, 0}, foot.yaw);
    const Vec3 knees = Rotate(pose_.hips_turn, Normalized(pose_.knees + Vec3{side * pose_.knees_out, 0, 0}));
    const Limb limb =
        Reach(At(thigh).position, foot.ankle, Size::kThigh, Size::kShin, knees + Rotate(yaw, {0, 0, 0.4f}));
    Hang(thigh, limb.upper);
    Hang(thigh + 1, limb.lower);
    const Quat turn = yaw * Turn({1, 0, 0}, foot.pitch) * Turn({0, 0, 1}, foot.roll);
    Hang(thigh + 2, turn);
    Hang(thigh + 3, turn * Turn({1, 0, 0}, foot.toe_pitch));
  }

  const SoldierPose& pose_;
  const Skeleton& skeleton_;
  std::vector<BonePose> model_;
};

float Between(float a, float b, float share) {
  return a + (b - a) * share;
}

SoldierPose::Foot Between(const SoldierPose::Foot& a, const SoldierPose::Foot& b, float share) {
  return {Between(a.ankle, b.ankle, share), Between(a.yaw, b.yaw, share), Between(a.pitch, b.pitch, share),
          Between(a.toe_pitch, b.toe_pitch, share), Between(a.roll, b.roll, share)};
}

}  // namespace

SoldierPose Between(const SoldierPose& a, const SoldierPose& b, float share) {
  using Pose = SoldierPose;
  SoldierPose pose;
  const auto blend = [&](auto... members) { ((pose.*members = Between(a.*members, b.*members, share)), ...); };
  blend(&Pose::hips, &Pose::hips_turn, &Pose::chest_turn, &Pose::head_turn, &Pose::left, &Pose::right, &Pose::knees);
  blend(&Pose::rifle, &Pose::rifle_frame, &Pose::barrel, &Pose::rifle_up, &Pose::left_elbow, &Pose::right_elbow);
  blend(&Pose::left_wrist, &Pose::left_fingers, &Pose::left_palm);
  blend(&Pose::right_wrist, &Pose::right_fingers, &Pose::right_palm);
  blend(&Pose::knees_out, &Pose::left_off_rifle, &Pose::right_off_rifle, &Pose::shoulders_forward);
  return pose;
}

std::vector<BonePose> SolvePose(const SoldierPose& pose) {
  return Solver(pose).Solve();
}

}  // namespace soarbox::world
