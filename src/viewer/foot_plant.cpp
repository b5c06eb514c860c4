// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/foot_plant.h"

#include <algorithm>
#include <cmath>

#include "viewer/half_turn.h"
#include "world/animation/soldier_skeleton.h"

namespace soarbox::viewer {
namespace {

using world::BonePose;
using world::Quat;
using world::Vec3;
using Size = world::SoldierSize;

constexpr Vec3 kUp{0, 1, 0};

/// A foot is set down below the first height and lifted above the second.
constexpr float kDown_m = 0.010f, kLeaves_m = 0.014f;
/// The other end of the sole carries the body when it is lower by this amount.
constexpr float kRolls_m = 0.006f;
/// Feet in the air lose their difference from the animation in about this time.
constexpr float kReturns_s = 0.09f;
/// A standing body takes a step if a foot differs from the animation by this amount; after kSettles_s, by the smaller
/// one.
constexpr float kStep_m = 0.10f, kStep_rad = 0.45f, kSettle_m = 0.04f, kSettle_rad = 0.15f, kSettles_s = 0.5f;
constexpr float kStepTakes_s = 0.26f, kStepLift_m = 0.05f;
constexpr float kStanding_mps = 0.7f;
/// Maximum difference from the animation of a foot on the ground.
constexpr float kFarthest_m = 0.34f, kFarthest_rad = 0.9f;
/// Maximum distance from hip to ankle.
constexpr float kLegs_m = 0.998f * (Size::kThigh + Size::kShin);
/// Below this height of the hips a body does not stand on its feet.
constexpr float kLying_m = 0.45f;

float Wrapped(float angle) {
  return std::remainder(angle, 2 * kPi);
}

float Ease(float t) {
  return t * t * (3 - 2 * t);
}

Vec3 Flat(Vec3 v) {
  return {v.x, 0, v.z};
}

/// The shortest turn from one direction to another.
Quat TurnBetween(Vec3 from, Vec3 to) {
  const Vec3 a = world::Normalized(from), b = world::Normalized(to);
  const Vec3 axis = Cross(a, b);
  const float w = 1 + Dot(a, b);
  if (w < 1e-4f) return {};
  return world::Normalized(Quat{w, axis.x, axis.y, axis.z});
}

/// Bends a leg until its ankle is at `ankle`, and turns the foot by `turn`.
void MoveLeg(std::vector<BonePose>& bones, int thigh, Vec3 ankle, float turn) {
  const auto bone = [&](int i) -> BonePose& { return bones[static_cast<std::size_t>(thigh + i)]; };
  const Vec3 hip = bone(0).position, knee = bone(1).position, old_ankle = bone(2).position;
  const float upper = world::Distance(hip, knee), lower = world::Distance(knee, old_ankle);
  const Vec3 way = ankle - hip;
  const float length = std::clamp(world::Length(way), std::abs(upper - lower) + 0.02f, 0.999f * (upper + lower));
  const Vec3 direction = world::Normalized(way);
  const Vec3 reached = hip + direction * length;
  // The knee stays on its side of the leg.
  Vec3 side = (knee - hip) - direction * Dot(knee - hip, direction);
  const Vec3 ahead = Rotate(bone(2).orientation, {0, 0, 1});
  if (world::LengthSquared(side) < 1e-6f) side = ahead - direction * Dot(ahead, direction);
  const float cosine =
      std::clamp((upper * upper + length * length - lower * lower) / (2 * upper * length), -1.0f, 1.0f);
  const Vec3 new_knee =
      hip + direction * (upper * cosine) + world::Normalized(side) * (upper * std::sqrt(1 - cosine * cosine));
  bone(0).orientation = TurnBetween(knee - hip, new_knee - hip) * bone(0).orientation;
  bone(1).orientation = TurnBetween(old_ankle - knee, reached - new_knee) * bone(1).orientation;
  bone(1).position = new_knee;
  const Quat round = world::Turn(kUp, turn);
  bone(3).position = reached + Rotate(round, bone(3).position - old_ankle);
  bone(3).orientation = round * bone(3).orientation;
  bone(2).position = reached;
  bone(2).orientation = round * bone(2).orientation;
}

}  // namespace

/// A foot as the animation has it, in world space except for the heights.
struct FootPlant::Sole {
  Vec3 ankle, heel, ball;
  float heel_m = 0, ball_m = 0;  ///< Above the ground that the model stands on.
  float yaw = 0;

  Sole(const SkinPlace& place, const std::vector<BonePose>& bones, int foot) {
    const BonePose& ankle_bone = bones[static_cast<std::size_t>(foot)];
    const BonePose& toe_bone = bones[static_cast<std::size_t>(foot + 1)];
    const Vec3 heel_in_model = ankle_bone.Apply({0, -Size::kAnkle, -Size::kHeel});
    const Vec3 ball_in_model = toe_bone.position - Vec3{0, 0.02f, 0};
    heel_m = heel_in_model.y;
    ball_m = ball_in_model.y;
    const auto in_world = [&place](Vec3 v) { return place.at.Apply(v * place.scale.x); };
    ankle = in_world(ankle_bone.position);
    heel = in_world(heel_in_model);
    ball = in_world(ball_in_model);
    const Vec3 ahead = ball - heel;
    yaw = std::atan2(ahead.x, ahead.z);
  }
  float lowest_m() const { return std::min(heel_m, ball_m); }
  Vec3 Carrying(bool on_heel) const { return on_heel ? heel : ball; }
  /// Where one of its points is drawn.
  Vec3 Drawn(Vec3 point, const Foot& foot) const {
    return ankle + foot.offset + Rotate(world::Turn(kUp, foot.turn), point - ankle);
  }
};

void FootPlant::BeginStep(Foot& foot) {
  foot.step = 0;
  foot.step_offset = foot.offset;
  foot.step_turn = foot.turn;
}

void FootPlant::Hold(Foot& foot, const Foot& other, const Sole& sole, bool is_new, float seconds, float speed_mps) {
  if (is_new) foot = {};
  if (is_lying_) foot.step = -1;
  const auto stand = [&] {
    foot.stands = true;
    foot.step = -1;
    foot.on_heel = sole.heel_m < sole.ball_m;
    foot.at = Flat(sole.Drawn(sole.Carrying(foot.on_heel), foot));
    foot.yaw = sole.yaw + foot.turn;
  };
  if (foot.step >= 0) {
    foot.step = std::min(1.0f, foot.step + seconds / kStepTakes_s);
    const float left = 1 - Ease(foot.step);
    foot.offset = foot.step_offset * left;
    foot.offset.y = std::max(0.0f, -sole.lowest_m()) + kStepLift_m * std::sin(kPi * foot.step);
    foot.turn = foot.step_turn * left;
    if (foot.step >= 1) stand();
    return;
  }
  // Blended animations may push a sole into the ground.
  foot.offset.y = std::max(0.0f, -sole.lowest_m());
  if (is_lying_ || sole.lowest_m() > kLeaves_m) foot.stands = false;
  if (!foot.stands) {
    const float kept = std::exp(-seconds / kReturns_s);
    foot.offset = {foot.offset.x * kept, foot.offset.y, foot.offset.z * kept};
    foot.turn *= kept;
    if (!is_lying_ && sole.lowest_m() < kDown_m) stand();
    return;
  }
  foot.turn = std::clamp(Wrapped(foot.yaw - sole.yaw), -kFarthest_rad, kFarthest_rad);
  foot.yaw = sole.yaw + foot.turn;
  const Vec3 carrying = sole.Carrying(foot.on_heel);
  Vec3 offset = Flat(foot.at - sole.ankle - Rotate(world::Turn(kUp, foot.turn), carrying - sole.ankle));
  const float away = world::Length(offset);
  if (away > kFarthest_m) BeginStep(foot);
  foot.offset = {offset.x, foot.offset.y, offset.z};
  // The sole rolls from heel to ball.
  const float other_end_m = foot.on_heel ? sole.ball_m : sole.heel_m, own_m = foot.on_heel ? sole.heel_m : sole.ball_m;
  if (other_end_m + kRolls_m < own_m) foot.on_heel = !foot.on_heel;
  foot.at = Flat(sole.Drawn(sole.Carrying(foot.on_heel), foot));
  if (speed_mps > kStanding_mps || other.step >= 0 || !other.stands) return;
  if (foot.step >= 0) return;
  const float turned = std::abs(foot.turn);
  if (away > kStep_m || turned > kStep_rad) BeginStep(foot);
  if (still_s_ > kSettles_s && (away > kSettle_m || turned > kSettle_rad)) BeginStep(foot);
}

void FootPlant::Follow(const SkinPlace& place, float seconds, std::vector<BonePose>& bones) {
  const bool has_legs = bones.size() == world::kSoldierBones;
  const bool is_even = place.scale.x == place.scale.y && place.scale.x == place.scale.z && place.scale.x > 0;
  if (!has_legs || !is_even) {
    known_ = false;
    return;
  }
  const float speed = known_ ? world::Length(Flat(place.at.position - last_place_)) / std::max(seconds, 1e-3f) : 0;
  constexpr float kFastest_mps = 12;  // A faster body was placed there.
  const bool is_new = !known_ || speed > kFastest_mps;
  known_ = true;
  last_place_ = place.at.position;
  is_lying_ = bones[world::kHips].position.y < kLying_m;
  still_s_ = speed < 0.05f ? still_s_ + seconds : 0;
  const Quat back = world::Conjugate(place.at.orientation);
  for (int i = 0; i < 2; ++i) {
    const int thigh = i == 0 ? world::kLeftThigh : world::kRightThigh;
    const Sole sole(place, bones, thigh + 2);
    Foot& foot = feet_[i];
    Hold(foot, feet_[1 - i], sole, is_new, seconds, speed);
    const auto ankle = [&] {
      return bones[static_cast<std::size_t>(thigh + 2)].position + Rotate(back, foot.offset) / place.scale.x;
    };
    // A body that has moved further than the leg reaches takes the foot along.
    const Vec3 hip = bones[static_cast<std::size_t>(thigh)].position;
    if (foot.stands && foot.step < 0 && world::Distance(hip, ankle()) > kLegs_m) {
      BeginStep(foot);
      Hold(foot, feet_[1 - i], sole, false, seconds, speed);
    }
    if (foot.offset == Vec3{} && foot.turn == 0) continue;
    MoveLeg(bones, thigh, ankle(), foot.turn);
  }
}

}  // namespace soarbox::viewer
