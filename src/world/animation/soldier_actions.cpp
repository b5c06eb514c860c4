// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/animation/soldier_clips.h"
#include "world/animation/soldier_skeleton.h"

// Animations of a soldier that do not move the body. Each is a sequence of poses with smooth transitions.
namespace soarbox::world {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
using Size = SoldierSize;

struct Moment {
  float at;  ///< Time of the pose, 0..1 of the clip.
  SoldierPose pose;
};
using Moments = std::vector<Moment>;

float Ease(float t) {
  return t * t * (3 - 2 * t);
}

SoldierPose PoseAt(const Moments& moments, float at) {
  for (std::size_t i = 1; i < moments.size(); ++i) {
    if (at > moments[i].at) continue;
    const float span = moments[i].at - moments[i - 1].at;
    return Between(moments[i - 1].pose, moments[i].pose, Ease((at - moments[i - 1].at) / span));
  }
  return moments.back().pose;
}

Clip FromMoments(const Clip::Settings& settings, const Moments& moments) {
  return MakeClip(settings, [&](float at) { return PoseAt(moments, at); });
}

template <class Change>
SoldierPose With(SoldierPose pose, Change change) {
  change(pose);
  return pose;
}

/// Breathing, and small shifts of weight.
SoldierPose Breathing(SoldierPose pose, float phase, float size) {
  const float breath = std::sin(2 * kPi * phase), shift = std::sin(2 * kPi * phase + 1.1f);
  pose.hips += Vec3{0.006f * shift, 0.003f * breath, 0} * size;
  pose.chest_turn = pose.chest_turn * Turn({1, 0, 0}, -0.014f * breath * size);
  pose.rifle += Vec3{0, 0.005f * breath, 0.002f * shift} * size;
  pose.head_turn = pose.head_turn * Turn({1, 0, 0}, 0.008f * breath * size);
  return pose;
}

/// Stands and occasionally looks around.
SoldierPose LookingAround(SoldierPose pose, float phase) {
  const float look = 0.45f * std::sin(2 * kPi * phase) * Ease(std::abs(std::sin(2 * kPi * phase)));
  pose = Breathing(pose, std::fmod(2 * phase, 1.0f), 1.3f);
  pose.head_turn = Turn({0, 1, 0}, look) * pose.head_turn;
  pose.chest_turn = Turn({0, 1, 0}, 0.15f * look) * pose.chest_turn;
  return pose;
}

Moments Fire(const SoldierPose& aim) {
  const SoldierPose kicked = With(aim, [](SoldierPose& p) {
    p.rifle += Vec3{0.0f, 0.012f, -0.045f};
    p.barrel.y += 0.055f;
    p.chest_turn = p.chest_turn * Turn({1, 0, 0}, -0.055f) * Turn({0, 1, 0}, -0.04f);
    p.head_turn = p.head_turn * Turn({1, 0, 0}, -0.04f);
    p.hips.z -= 0.008f;
  });
  return {{0, aim}, {0.12f, kicked}, {0.7f, aim}, {1, aim}};
}

/// The left hand removes the magazine, takes another one from the vest and inserts it.
Moments Reload(const SoldierPose& aim) {
  const SoldierPose lowered = With(aim, [](SoldierPose& p) {
    p.rifle = {-0.105f, -0.17f, 0.265f};
    p.barrel = {0.22f, 0.22f, 0.95f};
    p.rifle_up = {0.45f, 0.85f, -0.1f};
    p.head_turn = Turn({0, 1, 0}, 0.06f) * Turn({1, 0, 0}, 0.36f);
    p.chest_turn = Turn({0, 1, 0}, -0.32f) * Turn({1, 0, 0}, 0.10f);
    p.right_elbow = {-0.8f, -0.9f, -0.35f};
  });
  const auto hand = [](const SoldierPose& pose, Vec3 place, Vec3 fingers, Vec3 palm) {
    return With(pose, [&](SoldierPose& p) {
      p.left_off_rifle = 1;
      p.left_wrist = place;
      p.left_fingers = fingers;
      p.left_palm = palm;
      p.left_elbow = {0.8f, -0.9f, -0.25f};
    });
  };
  const SoldierPose at_magazine = hand(lowered, {-0.02f, -0.26f, 0.30f}, {-0.35f, 0.75f, 0.45f}, {-0.8f, 0.0f, -0.4f});
  const SoldierPose pulled = hand(lowered, {0.05f, -0.40f, 0.32f}, {-0.35f, 0.75f, 0.45f}, {-0.8f, 0.0f, -0.4f});
  const SoldierPose at_vest = hand(lowered, {0.13f, -0.40f, 0.14f}, {-0.55f, -0.5f, -0.25f}, {0.2f, 0.3f, -0.9f});
  const SoldierPose home = With(at_magazine, [](SoldierPose& p) {
    p.left_wrist.y += 0.03f;
    p.rifle.y += 0.015f;
  });
  const SoldierPose at_bolt = hand(lowered, {0.01f, -0.17f, 0.27f}, {-0.75f, 0.3f, 0.45f}, {-0.4f, -0.6f, -0.4f});
  const SoldierPose bolt_back = hand(lowered, {0.02f, -0.17f, 0.19f}, {-0.75f, 0.3f, 0.45f}, {-0.4f, -0.6f, -0.4f});
  return {{0, aim},         {0.12f, lowered},   {0.22f, at_magazine}, {0.32f, pulled},
          {0.44f, at_vest}, {0.52f, at_vest},   {0.63f, pulled},      {0.70f, home},
          {0.78f, at_bolt}, {0.84f, bolt_back}, {0.89f, lowered},     {1, aim}};
}

/// A blow with the butt.
Moments Melee(const SoldierPose& aim) {
  const SoldierPose back = With(aim, [](SoldierPose& p) {
    p.rifle = {-0.10f, -0.10f, 0.20f};
    p.barrel = {0.25f, 0.85f, -0.25f};
    p.rifle_up = {-0.2f, -0.1f, -1.0f};
    p.chest_turn = Turn({0, 1, 0}, -0.85f);
    p.hips.z -= 0.04f;
  });
  const SoldierPose struck = With(aim, [](SoldierPose& p) {
    p.rifle = {0.02f, 0.02f, 0.42f};
    p.barrel = {0.45f, 0.55f, -0.65f};
    p.rifle_up = {-0.3f, 0.5f, -0.6f};
    p.chest_turn = Turn({0, 1, 0}, 0.45f) * Turn({1, 0, 0}, 0.25f);
    p.hips_turn = Turn({0, 1, 0}, 0.10f) * Turn({1, 0, 0}, 0.1f);
    p.hips += Vec3{0.02f, -0.04f, 0.13f};
    p.right.pitch = 0.6f;
    p.right.toe_pitch = -0.6f;
    p.right.ankle.y += 0.06f;
  });
  return {{0, aim}, {0.32f, back}, {0.50f, struck}, {0.62f, struck}, {1, aim}};
}

/// Staggers after a hit.
Moments Hit(const SoldierPose& aim) {
  const SoldierPose staggered = With(aim, [](SoldierPose& p) {
    p.chest_turn = Turn({0, 1, 0}, -0.95f) * Turn({1, 0, 0}, -0.12f) * Turn({0, 0, 1}, 0.12f);
    p.head_turn = Turn({0, 1, 0}, -0.25f) * Turn({1, 0, 0}, -0.18f);
    p.hips += Vec3{-0.03f, -0.05f, -0.06f};
    p.rifle += Vec3{-0.04f, -0.08f, -0.04f};
    p.barrel = {0.1f, 0.35f, 0.9f};
  });
  return {{0, aim}, {0.25f, staggered}, {0.45f, staggered}, {1, aim}};
}

/// On the back, with the limbs spread.
SoldierPose LyingOnBack() {
  SoldierPose p = StandReady();
  p.hips = {0.03f, 0.120f, -0.42f};
  p.hips_turn = Turn({1, 0, 0}, -1.50f) * Turn({0, 1, 0}, 0.10f);
  p.chest_turn = Turn({1, 0, 0}, -1.28f) * Turn({0, 1, 0}, -0.12f);  // The backpack is below.
  p.head_turn = Turn({1, 0, 0}, -1.55f) * Turn({0, 1, 0}, 0.60f);
  p.left = {{0.20f, 0.085f, 0.33f}, 0.55f, -1.0f};
  p.right = {{-0.26f, 0.085f, 0.12f}, -0.70f, -0.75f};
  p.knees_out = 0.55f;
  p.rifle_frame = p.chest_turn;
  p.rifle = {-0.34f, -0.22f, 0.02f};
  p.barrel = {0.45f, -0.86f, 0.10f};
  p.rifle_up = {0.85f, 0.45f, 0.10f};
  p.right_elbow = {-0.9f, -0.3f, 0.15f};
  p.left_off_rifle = 1;
  p.left_wrist = {0.46f, -0.24f, -0.09f};
  p.left_fingers = {0.75f, -0.45f, -0.05f};
  p.left_palm = {0.1f, 0.1f, 1};
  p.left_elbow = {0.8f, -0.3f, 0.1f};
  p.shoulders_forward = -0.1f;
  return p;
}

/// Face down, one arm under the body.
SoldierPose LyingOnFace() {
  SoldierPose p = StandReady();
  p.hips = {0.02f, 0.120f, 0.34f};
  p.hips_turn = Turn({1, 0, 0}, 1.52f) * Turn({0, 1, 0}, 0.08f);
  p.chest_turn = Turn({1, 0, 0}, 1.50f) * Turn({0, 1, 0}, -0.10f);
  p.head_turn = Turn({1, 0, 0}, 1.35f) * Turn({0, 1, 0}, 0.75f);
  p.left = {{0.18f, 0.115f, -0.44f}, 0.25f, 1.35f};
  p.right = {{-0.24f, 0.115f, -0.24f}, -0.45f, 1.35f};
  p.knees = {0, 0, 0.08f};
  p.knees_out = 1.0f;
  p.rifle_frame = p.chest_turn;
  p.rifle = {-0.24f, 0.14f, 0.045f};
  p.barrel = {0.55f, 0.80f, 0.02f};
  p.rifle_up = {-0.80f, 0.55f, 0.1f};
  p.right_elbow = {-0.9f, -0.3f, 0.1f};
  p.left_off_rifle = 1;
  p.left_wrist = {0.40f, 0.10f, 0.05f};
  p.left_fingers = {0.35f, 0.8f, 0.05f};
  p.left_palm = {0.1f, 0.1f, 1};
  p.left_elbow = {0.9f, -0.1f, 0.1f};
  p.shoulders_forward = 0.1f;
  return p;
}

/// The knees bend, and the body falls on its face.
Moments Dying(const SoldierPose& from, bool crouched) {
  const SoldierPose hit = With(from, [&](SoldierPose& p) {
    p.chest_turn = Turn({0, 1, 0}, -0.30f) * Turn({1, 0, 0}, -0.12f);
    p.head_turn = Turn({1, 0, 0}, -0.30f) * Turn({0, 1, 0}, 0.2f);
    p.hips += Vec3{0, crouched ? -0.02f : -0.06f, -0.04f};
    p.rifle = {-0.12f, -0.16f, 0.24f};
    p.barrel = {0.35f, 0.15f, 0.9f};
  });
  const SoldierPose kneeling = With(StandReady(), [](SoldierPose& p) {
    p.hips = {0.0f, 0.47f, 0.0f};
    p.hips_turn = Turn({1, 0, 0}, 0.05f);
    p.chest_turn = Turn({1, 0, 0}, 0.30f) * Turn({0, 0, 1}, 0.08f);
    p.head_turn = Turn({1, 0, 0}, 0.55f);
    p.left = {{0.12f, 0.10f, -0.40f}, 0.1f, 1.25f};
    p.right = {{-0.14f, 0.10f, -0.38f}, -0.1f, 1.25f};
    p.knees_out = 0.2f;
    p.rifle_frame = p.chest_turn;
    p.rifle = {-0.20f, -0.40f, 0.15f};
    p.barrel = {0.55f, -0.45f, 0.6f};
    p.left_off_rifle = 0.8f;
    p.left_wrist = {0.16f, -0.42f, 0.16f};
    p.left_fingers = {-0.2f, -0.9f, 0.3f};
    p.left_palm = {-0.9f, 0, -0.3f};
  });
  const SoldierPose falling = With(Between(kneeling, LyingOnFace(), 0.55f), [](SoldierPose& p) {
    p.hips.y += 0.05f;
    p.left_off_rifle = 1;
  });
  const SoldierPose lying = LyingOnFace();
  if (crouched) return {{0, from}, {0.18f, hit}, {0.40f, kneeling}, {0.58f, falling}, {0.74f, lying}, {1, lying}};
  return {{0, from}, {0.16f, hit}, {0.45f, kneeling}, {0.62f, falling}, {0.78f, lying}, {1, lying}};
}

/// Thrown back by a shot in the head.
Moments DyingAtOnce(const SoldierPose& from) {
  const SoldierPose struck = With(from, [](SoldierPose& p) {
    p.head_turn = Turn({1, 0, 0}, -0.75f) * Turn({0, 1, 0}, 0.2f);
    p.chest_turn = Turn({1, 0, 0}, -0.35f) * Turn({0, 1, 0}, -0.3f);
    p.hips += Vec3{0, -0.03f, -0.10f};
    p.rifle = {-0.18f, -0.10f, 0.24f};
    p.barrel = {0.30f, 0.55f, 0.75f};
  });
  const SoldierPose tilting = With(Between(struck, LyingOnBack(), 0.5f), [](SoldierPose& p) {
    p.hips = {0.02f, 0.50f, -0.36f};
    p.hips_turn = Turn({1, 0, 0}, -0.75f);
    p.chest_turn = Turn({1, 0, 0}, -0.95f);
    p.left = {{0.13f, 0.10f, 0.14f}, 0.1f, -0.35f};
    p.right = {{-0.16f, 0.09f, 0.02f}, -0.4f, -0.2f};
    p.left_off_rifle = 1;
    p.left_wrist = {0.45f, 0.05f, 0.20f};
  });
  const SoldierPose lying = LyingOnBack();
  const SoldierPose bounced = With(lying, [](SoldierPose& p) {
    p.chest_turn = p.chest_turn * Turn({1, 0, 0}, 0.08f);
    p.left.ankle.y += 0.06f;
  });
  return {{0, from}, {0.14f, struck}, {0.42f, tilting}, {0.60f, lying}, {0.70f, bounced}, {0.82f, lying}, {1, lying}};
}

SoldierPose Ducked(const SoldierPose& aim, float depth_m) {
  return With(aim, [&](SoldierPose& p) {
    p.hips.y -= depth_m;
    p.hips.z -= 0.3f * depth_m;
    p.chest_turn = p.chest_turn * Turn({1, 0, 0}, 1.1f * depth_m);
    p.rifle.y -= 0.2f * depth_m;
  });
}

SoldierPose InTheAir(const SoldierPose& aim) {
  return With(aim, [](SoldierPose& p) {
    p.hips.y += 0.02f;
    p.left.ankle += Vec3{0, 0.16f, 0.02f};
    p.left.pitch = 0.35f;
    p.right.ankle += Vec3{0, 0.22f, -0.08f};
    p.right.pitch = 0.8f;
    p.rifle.y -= 0.05f;
  });
}

/// The right hand operates the rifle while that changes its shape.
Moments Transform(const SoldierPose& aim) {
  const SoldierPose held = With(aim, [](SoldierPose& p) {
    p.rifle = {-0.10f, -0.20f, 0.28f};
    p.barrel = {0.55f, 0.35f, 0.75f};
    p.rifle_up = {-0.25f, 0.9f, -0.25f};
    p.head_turn = Turn({0, 1, 0}, 0.12f) * Turn({1, 0, 0}, 0.32f);
    p.chest_turn = Turn({0, 1, 0}, -0.25f) * Turn({1, 0, 0}, 0.08f);
  });
  const SoldierPose shaken = With(held, [](SoldierPose& p) {
    p.rifle += Vec3{0.02f, 0.03f, 0.03f};
    p.barrel = {0.60f, 0.45f, 0.65f};
  });
  return {{0, aim}, {0.25f, held}, {0.45f, shaken}, {0.55f, held}, {0.65f, shaken}, {0.75f, held}, {1, aim}};
}

}  // namespace

void AddActions(std::vector<Clip>& clips) {
  const SoldierPose aim = StandAiming(), ready = StandReady(), crouch = CrouchAiming();
  const auto cycle = [&clips](const char* name, float length_s, const std::function<SoldierPose(float)>& pose_at) {
    clips.push_back(MakeClip({.name = name, .length_s = length_s, .is_cycle = true}, pose_at));
  };
  const auto upper = [&clips](const char* name, float length_s, const Moments& moments) {
    clips.push_back(FromMoments({.name = name, .length_s = length_s, .upper_body = true}, moments));
  };
  const auto whole = [&clips](const char* name, float length_s, const Moments& moments) {
    clips.push_back(FromMoments({.name = name, .length_s = length_s}, moments));
  };
  cycle("stand_idle", 6.0f, [&](float at) { return LookingAround(ready, at); });
  cycle("stand_idle_free", 6.0f, [&](float at) { return LookingAround(StandFree(), at); });
  cycle("stand_idle_aim", 3.0f, [&](float at) { return Breathing(aim, at, 1); });
  cycle("crouch_idle_aim", 3.0f, [&](float at) { return Breathing(crouch, at, 0.8f); });
  upper("stand_fire_one_shot", 0.5f, Fire(aim));
  upper("crouch_fire_one_shot", 0.5f, Fire(crouch));
  upper("stand_reload", 2.6f, Reload(aim));
  upper("crouch_reload", 2.6f, Reload(crouch));
  upper("stand_melee_1_with_weapon", 0.9f, Melee(aim));
  upper("stand_hit", 0.5f, Hit(aim));
  upper("crouch_hit", 0.5f, Hit(crouch));
  upper("stand_smg_transform", 1.2f, Transform(aim));
  upper("stand_sniper_transform", 1.2f, Transform(aim));
  whole("stand_dead_2", 1.9f, Dying(aim, false));
  whole("crouch_dead", 1.5f, Dying(crouch, true));
  whole("stand_dead_headshot", 1.5f, DyingAtOnce(aim));
  whole("stand_jump_up", 0.5f, {{0, aim}, {0.45f, Ducked(aim, 0.16f)}, {0.8f, InTheAir(aim)}, {1, InTheAir(aim)}});
  whole("stand_jump_land", 0.6f,
        {{0, InTheAir(aim)}, {0.2f, Ducked(aim, 0.05f)}, {0.45f, Ducked(aim, 0.22f)}, {1, aim}});
  whole("stand_to_crouch", 0.5f, {{0, aim}, {1, crouch}});
}

}  // namespace soarbox::world
