// SPDX-License-Identifier: BSD-2-Clause
#include <cmath>
#include <numbers>
#include <string_view>

#include "world/animation/soldier_clips.h"
#include "world/animation/soldier_skeleton.h"

// Walking and running. A foot that carries the body does not move on the ground, so relative to the body it moves back
// at the speed of the gait. The left foot lands at the start of a cycle, the right one in its middle.
namespace soarbox::world {
namespace {

constexpr float kHalfTurn = std::numbers::pi_v<float>;
using Size = SoldierSize;

enum class Carry { kReady, kAim, kPort, kNothing };

struct Gait {
  const char* name;
  float speed_mps;
  float period_s;
  float stance;       ///< Fraction of the cycle in which a foot is on the ground.
  float heading = 0;  ///< Direction of movement, from the front to the left, in rad.
  float hips_m;       ///< Height.
  float bob_m;
  float lift_m;          ///< Height of the swinging foot.
  float lean = 0.05f;    ///< Forward, in rad.
  float landing = 0.3f;  ///< Toes up when the foot lands.
  float push_off = 0.7f;
  float side_m = 0.09f;
  float twist = 0.10f;  ///< Rotation of the hips.
  bool runs = false;
  Carry carry = Carry::kReady;
};

/// A smooth transition from 0 to 1.
float EaseGait(float t) {
  t = std::clamp(t, 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// Position of an ankle if the foot is pitched about its heel (toes up, below 0) or its ball (toes down).
Vec3 AnkleOver(Vec3 sole, float pitch) {
  const Vec3 pivot = pitch > 0 ? Vec3{0, 0.01f, Size::kBall} : Vec3{0, 0, -Size::kHeel};
  return sole + pivot + Rotate(Turn({1, 0, 0}, pitch), Vec3{0, Size::kAnkle, 0} - pivot);
}

/// The pose of one foot at its phase, 0..1 from landing to landing.
SoldierPose::Foot FootAt(const Gait& gait, float phase, float side) {
  const float way = gait.speed_mps * gait.period_s * gait.stance;
  const Vec3 ahead{std::sin(gait.heading), 0, std::cos(gait.heading)};
  const bool forward = ahead.z > 0.5f;
  const float landing = forward ? -gait.landing : 0.0f, leaving = forward ? gait.push_off : 0.25f * gait.push_off;
  // A running body leans forward, so its feet are a little behind it on average.
  const float middle = gait.runs ? -0.16f * way : forward ? -0.07f : -0.02f;
  SoldierPose::Foot foot;
  Vec3 ankle;
  if (phase < gait.stance) {
    const float t = phase / gait.stance;
    foot.pitch = t < 0.2f ? landing * (1 - EaseGait(t / 0.2f)) : leaving * EaseGait((t - 0.5f) / 0.5f) * EaseGait(t);
    ankle = AnkleOver(ahead * (middle + way * (0.5f - t)), foot.pitch);
    foot.toe_pitch = -std::max(foot.pitch, 0.0f);
  } else {
    const float t = (phase - gait.stance) / (1 - gait.stance);
    const Vec3 from = AnkleOver(ahead * (middle - 0.5f * way), leaving);
    const Vec3 to = AnkleOver(ahead * (middle + 0.5f * way), landing);
    // Leaves and reaches the ground at the speed of the ground.
    const float speed = -gait.speed_mps * gait.period_s * (1 - gait.stance) * 0.35f;
    const float t2 = t * t, t3 = t2 * t;
    const float place = 3 * t2 - 2 * t3, tangents = speed * (2 * t3 - 3 * t2 + t);
    ankle = from + (to - from) * place + ahead * tangents;
    ankle.y = from.y + (to.y - from.y) * EaseGait(t) +
              gait.lift_m * std::sin(kHalfTurn * std::pow(t, gait.runs ? 0.75f : 0.9f));
    const float kick = gait.runs && forward ? 0.9f : 0.15f;
    foot.pitch =
        leaving + (landing - leaving) * EaseGait(t * 1.15f) + kick * gait.push_off * std::sin(kHalfTurn * t) * (1 - t);
    foot.toe_pitch = -leaving * (1 - EaseGait(t * 4));
  }
  foot.ankle = ankle + Vec3{side * gait.side_m, 0, 0};
  foot.yaw = side * (gait.runs ? 0.04f : 0.10f);
  return foot;
}

SoldierPose GaitPose(const Gait& gait, float phase) {
  const bool aims = gait.carry == Carry::kAim, is_free = gait.carry == Carry::kNothing;
  SoldierPose pose = aims ? StandAiming() : is_free ? StandFree() : StandReady();
  const float cycle = 2 * kHalfTurn * phase;
  const float mid_stance = 0.5f * gait.stance;
  const float beat = gait.runs ? std::cos(2 * (cycle - 2 * kHalfTurn * mid_stance)) : std::cos(2 * cycle);
  const float swing = std::cos(cycle), sway = std::cos(cycle - 2 * kHalfTurn * mid_stance);
  const float forward = std::cos(gait.heading);
  pose.hips = {0.022f * sway, gait.hips_m - gait.bob_m * beat, 0.0f};
  const float blade = aims ? -0.28f : 0.0f;
  pose.hips_turn = Turn({0, 1, 0}, blade - gait.twist * swing * forward) * Turn({0, 0, 1}, -0.035f * sway) *
                   Turn({1, 0, 0}, 0.5f * gait.lean);
  const float chest_blade = aims ? -0.5f : is_free ? 0.0f : -0.06f;
  pose.chest_turn = Turn({0, 1, 0}, chest_blade + 0.9f * gait.twist * swing * forward) * Turn({0, 0, 1}, 0.02f * sway) *
                    Turn({1, 0, 0}, gait.lean + (aims ? 0.08f : 0.0f));
  pose.head_turn = aims ? pose.head_turn : Turn({1, 0, 0}, 0.25f * gait.lean);
  pose.left = FootAt(gait, phase, 1);
  pose.right = FootAt(gait, std::fmod(phase + 0.5f, 1.0f), -1);
  pose.knees_out = 0.07f;
  // The rifle moves slightly with the shoulders.
  const float nod = (gait.runs ? 0.035f : 0.012f) * std::cos(2 * cycle - 0.8f);
  if (aims) {
    pose.rifle_frame = Turn({0, 1, 0}, 0.06f * gait.twist / 0.1f * swing * 0.3f) * Turn({1, 0, 0}, 0.5f * nod);
    if (gait.runs) {
      // When running, the eye is above the sights.
      pose.rifle += Vec3{0.0f, -0.07f, 0.0f};
      pose.barrel = {0.12f, -0.16f, 1};
    }
  } else if (is_free) {
    // Arms swing opposite to the legs.
    const float size = gait.runs ? 0.62f : 0.36f * std::abs(forward), bend = gait.runs ? 1.45f : 0.30f;
    const float along = forward >= 0 ? swing : -swing;
    pose.rifle_frame = Turn({0, 1, 0}, 0.9f * gait.twist * swing * forward) * Turn({1, 0, 0}, 0.8f * gait.lean);
    SwingArm(pose, true, -0.10f - size * along, bend - 0.14f * along);
    SwingArm(pose, false, -0.10f + size * along, bend + 0.14f * along);
  } else {
    pose.rifle_frame = Turn({0, 1, 0}, 0.7f * gait.twist * swing) * Turn({1, 0, 0}, gait.lean * 0.8f + nod);
    pose.rifle += Vec3{0.015f * swing, 0.012f * beat, 0};
    if (gait.carry == Carry::kPort) {
      pose.rifle = {-0.150f, -0.26f, 0.215f};
      pose.barrel = {0.80f, 0.34f, 0.36f};
      pose.rifle_up = {-0.30f, 0.85f, 0.35f};
    }
  }
  return pose;
}

SoldierPose CrouchPose(const Gait& gait, float phase) {
  SoldierPose pose = GaitPose(gait, phase);
  pose.chest_turn = Turn({0, 1, 0}, -0.45f) * Turn({1, 0, 0}, 0.42f);
  pose.hips_turn = pose.hips_turn * Turn({1, 0, 0}, 0.28f);
  pose.hips.z -= 0.10f;
  pose.knees_out = 0.22f;
  return pose;
}

constexpr Gait kWalks[] = {
    {.name = "stand_walk_forward",
     .speed_mps = 1.3f,
     .period_s = 0.95f,
     .stance = 0.60f,
     .hips_m = 0.890f,
     .bob_m = 0.017f,
     .lift_m = 0.055f},
    {.name = "stand_walk_forward_aim",
     .speed_mps = 1.2f,
     .period_s = 0.98f,
     .stance = 0.62f,
     .hips_m = 0.875f,
     .bob_m = 0.012f,
     .lift_m = 0.05f,
     .lean = 0.08f,
     .carry = Carry::kAim},
    {.name = "stand_run_forward",
     .speed_mps = 3.2f,
     .period_s = 0.70f,
     .stance = 0.37f,
     .hips_m = 0.865f,
     .bob_m = 0.035f,
     .lift_m = 0.17f,
     .lean = 0.20f,
     .landing = 0.12f,
     .push_off = 0.85f,
     .side_m = 0.065f,
     .twist = 0.16f,
     .runs = true,
     .carry = Carry::kPort},
    {.name = "stand_run_forward_aim",
     .speed_mps = 3.0f,
     .period_s = 0.70f,
     .stance = 0.38f,
     .hips_m = 0.855f,
     .bob_m = 0.025f,
     .lift_m = 0.14f,
     .lean = 0.16f,
     .landing = 0.12f,
     .push_off = 0.8f,
     .side_m = 0.07f,
     .twist = 0.12f,
     .runs = true,
     .carry = Carry::kAim},
    {.name = "stand_sprint_forward",
     .speed_mps = 6.0f,
     .period_s = 0.56f,
     .stance = 0.26f,
     .hips_m = 0.865f,
     .bob_m = 0.035f,
     .lift_m = 0.27f,
     .lean = 0.34f,
     .landing = 0.05f,
     .push_off = 1.0f,
     .side_m = 0.045f,
     .twist = 0.22f,
     .runs = true,
     .carry = Carry::kPort},
    {.name = "stand_walk_backward_aim",
     .speed_mps = 1.0f,
     .period_s = 1.0f,
     .stance = 0.62f,
     .heading = kHalfTurn,
     .hips_m = 0.875f,
     .bob_m = 0.012f,
     .lift_m = 0.05f,
     .lean = 0.04f,
     .carry = Carry::kAim},
    {.name = "stand_run_backward_aim",
     .speed_mps = 2.2f,
     .period_s = 0.70f,
     .stance = 0.42f,
     .heading = kHalfTurn,
     .hips_m = 0.855f,
     .bob_m = 0.02f,
     .lift_m = 0.10f,
     .lean = 0.10f,
     .side_m = 0.08f,
     .runs = true,
     .carry = Carry::kAim},
    {.name = "stand_walk_left_aim",
     .speed_mps = 1.0f,
     .period_s = 0.80f,
     .stance = 0.58f,
     .heading = kHalfTurn / 2,
     .hips_m = 0.868f,
     .bob_m = 0.012f,
     .lift_m = 0.06f,
     .side_m = 0.15f,
     .carry = Carry::kAim},
    {.name = "stand_walk_right_aim",
     .speed_mps = 1.0f,
     .period_s = 0.80f,
     .stance = 0.58f,
     .heading = -kHalfTurn / 2,
     .hips_m = 0.868f,
     .bob_m = 0.012f,
     .lift_m = 0.06f,
     .side_m = 0.15f,
     .carry = Carry::kAim},
    {.name = "stand_walk_backward",
     .speed_mps = 1.0f,
     .period_s = 1.0f,
     .stance = 0.62f,
     .heading = kHalfTurn,
     .hips_m = 0.885f,
     .bob_m = 0.012f,
     .lift_m = 0.05f,
     .lean = 0.0f},
};

/// The gaits with empty hands are those with a rifle, without it.
constexpr struct {
  const char *name, *of;
} kFreeGaits[] = {
    {"stand_walk_forward_free", "stand_walk_forward"},     {"stand_run_forward_free", "stand_run_forward"},
    {"stand_sprint_forward_free", "stand_sprint_forward"}, {"stand_walk_backward_free", "stand_walk_backward"},
    {"stand_walk_left_free", "stand_walk_left_aim"},       {"stand_walk_right_free", "stand_walk_right_aim"}};

constexpr Gait kCrouches[] = {
    {.name = "crouch_forward_aim",
     .speed_mps = 1.0f,
     .period_s = 0.95f,
     .stance = 0.62f,
     .hips_m = 0.60f,
     .bob_m = 0.012f,
     .lift_m = 0.07f,
     .lean = 0.2f,
     .landing = 0.2f,
     .push_off = 0.6f,
     .side_m = 0.11f,
     .carry = Carry::kAim},
    {.name = "crouch_backward_aim",
     .speed_mps = 0.8f,
     .period_s = 0.95f,
     .stance = 0.62f,
     .heading = kHalfTurn,
     .hips_m = 0.60f,
     .bob_m = 0.012f,
     .lift_m = 0.06f,
     .lean = 0.2f,
     .side_m = 0.11f,
     .carry = Carry::kAim},
};

/// Stepping on the spot: the feet turn out and close again while the body turns.
SoldierPose TurningPose(const SoldierPose& stance, float phase, float way) {
  SoldierPose pose = stance;
  const auto step = [&](SoldierPose::Foot& foot, float own_phase) {
    // For half of the cycle a foot is on the ground, and rotates against the turn relative to the body.
    const float t = own_phase < 0.5f ? 1 - 4 * own_phase : -1 + 4 * EaseGait((own_phase - 0.5f) * 2) * 0.5f;
    const Quat round = Turn({0, 1, 0}, way * 0.30f * t);
    foot.ankle = Rotate(round, foot.ankle);
    foot.yaw += way * 0.30f * t;
    if (own_phase >= 0.5f) foot.ankle.y += 0.06f * std::sin(kHalfTurn * (own_phase - 0.5f) * 2);
  };
  step(pose.left, phase);
  step(pose.right, std::fmod(phase + 0.5f, 1.0f));
  pose.hips.y -= 0.015f + 0.006f * std::cos(4 * kHalfTurn * phase);
  return pose;
}

}  // namespace

void AddGaits(std::vector<Clip>& clips) {
  const auto settings = [](const Gait& gait) {
    return Clip::Settings{.name = gait.name, .length_s = gait.period_s, .is_cycle = true, .speed_mps = gait.speed_mps};
  };
  for (const Gait& gait : kWalks)
    clips.push_back(MakeClip(settings(gait), [&](float phase) { return GaitPose(gait, phase); }));
  for (const auto& [name, of] : kFreeGaits) {
    for (Gait gait : kWalks) {
      if (std::string_view(gait.name) != of) continue;
      gait.name = name;
      gait.carry = Carry::kNothing;
      clips.push_back(MakeClip(settings(gait), [&](float phase) { return GaitPose(gait, phase); }));
    }
  }
  for (const Gait& gait : kCrouches)
    clips.push_back(MakeClip(settings(gait), [&](float phase) { return CrouchPose(gait, phase); }));
  struct Turning {
    const char* name;
    SoldierPose stance;
    float way;
  };
  for (const Turning& turn :
       {Turning{"stand_turn_left", StandReady(), 1}, Turning{"stand_turn_right", StandReady(), -1},
        Turning{"stand_turn_left_aim", StandAiming(), 1}, Turning{"stand_turn_right_aim", StandAiming(), -1},
        Turning{"stand_turn_left_free", StandFree(), 1}, Turning{"stand_turn_right_free", StandFree(), -1}}) {
    clips.push_back(MakeClip({.name = turn.name, .length_s = 0.7f, .is_cycle = true},
                             [&](float phase) { return TurningPose(turn.stance, phase, turn.way); }));
  }
}

}  // namespace soarbox::world
