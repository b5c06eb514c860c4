// SPDX-License-Identifier: BSD-2-Clause
#include <cmath>

#include "world/animation/soldier_clips.h"
#include "world/animation/soldier_skeleton.h"

namespace soarbox::world {
namespace {

constexpr float kKeysPerSecond = 30;

}  // namespace

Clip MakeClip(const Clip::Settings& settings, const std::function<SoldierPose(float)>& pose_at) {
  const int steps = std::max(2, static_cast<int>(std::lround(settings.length_s * kKeysPerSecond)));
  std::vector<std::vector<BonePose>> keys;
  for (int i = 0; i < steps; ++i) keys.push_back(SolvePose(pose_at(static_cast<float>(i) / static_cast<float>(steps))));
  keys.push_back(settings.is_cycle ? keys.front() : SolvePose(pose_at(1)));
  return Clip(settings, std::move(keys));
}

SoldierPose StandAiming() {
  SoldierPose pose;
  pose.hips = {0.0f, 0.885f, -0.02f};
  pose.hips_turn = Turn({0, 1, 0}, -0.40f) * Turn({1, 0, 0}, 0.06f);
  pose.chest_turn = Turn({0, 1, 0}, -0.55f) * Turn({1, 0, 0}, 0.13f);
  pose.head_turn = Turn({0, 1, 0}, -0.04f) * Turn({1, 0, 0}, 0.09f) * Turn({0, 0, 1}, 0.16f);
  pose.left = {{0.115f, SoldierSize::kAnkle, 0.17f}, 0.05f};
  pose.right = {{-0.135f, SoldierSize::kAnkle, -0.17f}, -0.75f};
  pose.rifle = {-0.075f, -0.055f, 0.285f};
  pose.barrel = {0, -0.01f, 1};
  pose.rifle_up = {-0.05f, 1, 0};
  pose.left_elbow = {0.55f, -1.0f, 0.1f};
  pose.right_elbow = {-0.9f, -0.75f, -0.1f};
  pose.shoulders_forward = 0.16f;
  return pose;
}

SoldierPose StandReady() {
  SoldierPose pose;
  pose.hips = {0.0f, 0.905f, -0.01f};
  pose.hips_turn = Turn({0, 1, 0}, -0.14f);
  pose.chest_turn = Turn({0, 1, 0}, -0.16f) * Turn({1, 0, 0}, 0.03f);
  pose.head_turn = Turn({0, 1, 0}, 0.02f);
  pose.left = {{0.125f, SoldierSize::kAnkle, 0.06f}, 0.16f};
  pose.right = {{-0.130f, SoldierSize::kAnkle, -0.07f}, -0.32f};
  // Across the chest, with the muzzle down to the left.
  pose.rifle = {-0.135f, -0.30f, 0.225f};
  pose.barrel = {0.66f, -0.50f, 0.48f};
  pose.rifle_up = {0.35f, 0.85f, 0.25f};
  pose.left_elbow = {0.75f, -0.85f, -0.3f};
  pose.right_elbow = {-0.7f, -0.7f, -0.55f};
  pose.shoulders_forward = 0.10f;
  return pose;
}

void SwingArm(SoldierPose& pose, bool is_left, float forward, float bend) {
  using Size = SoldierSize;
  const float side = is_left ? 1.0f : -1.0f;
  // Upper arms hang slightly away from the body, forearms towards it.
  const auto along = [side](float angle, float out) {
    return Normalized(Vec3{side * out, -std::cos(angle), std::sin(angle)});
  };
  const float lower = forward + bend;
  const Vec3 elbow = Vec3{side * (Size::kShoulderSide + 0.012f), 0, 0} + along(forward, 0.16f) * Size::kUpperArm;
  const Vec3 direction = along(lower, 0.10f - 0.35f * std::sin(std::max(bend, 0.0f)));
  const Vec3 wrist = elbow + direction * (0.98f * Size::kForearm);
  const Vec3 palm = Normalized(Vec3{-side, 0, 0.0f});
  (is_left ? pose.left_off_rifle : pose.right_off_rifle) = 1;
  (is_left ? pose.left_wrist : pose.right_wrist) = wrist;
  (is_left ? pose.left_fingers : pose.right_fingers) = direction;
  (is_left ? pose.left_palm : pose.right_palm) = palm;
  (is_left ? pose.left_elbow : pose.right_elbow) = {side * 0.35f, -0.2f, -1};
}

SoldierPose StandFree() {
  SoldierPose pose = StandReady();
  pose.hips_turn = Turn({0, 1, 0}, -0.04f);
  pose.chest_turn = Turn({1, 0, 0}, 0.02f);
  pose.head_turn = {};
  pose.left = {{0.120f, SoldierSize::kAnkle, 0.02f}, 0.20f};
  pose.right = {{-0.120f, SoldierSize::kAnkle, -0.03f}, -0.20f};
  pose.shoulders_forward = 0.04f;
  SwingArm(pose, true, -0.05f, 0.22f);
  SwingArm(pose, false, -0.03f, 0.26f);
  return pose;
}

SoldierPose CrouchAiming() {
  SoldierPose pose = StandAiming();
  // On the right knee, the left foot in front.
  pose.hips = {0.0f, 0.475f, -0.10f};
  pose.hips_turn = Turn({0, 1, 0}, -0.30f) * Turn({1, 0, 0}, 0.10f);
  pose.chest_turn = Turn({0, 1, 0}, -0.50f) * Turn({1, 0, 0}, 0.20f);
  pose.left = {{0.135f, SoldierSize::kAnkle, 0.27f}, 0.05f};
  pose.right = {{-0.150f, 0.145f, -0.43f}, -0.25f, 1.10f, -1.0f};
  pose.knees_out = 0.22f;
  return pose;
}

}  // namespace soarbox::world
