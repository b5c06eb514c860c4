// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/foot_plant.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "world/animation/animator.h"
#include "world/animation/body_bones.h"
#include "world/animation/soldier_skeleton.h"

namespace soarbox::viewer {
namespace {

using world::BonePose;
using world::LocomotionStyle;
using world::Vec3;
using Size = world::SoldierSize;

constexpr float kTick_s = 1 / 30.0f;

/// A body that moves as requested while its feet are measured.
class Walk {
 public:
  Walk(LocomotionStyle style, bool holds) : animator_(world::SoldierRig()), holds_(holds) {
    animator_.SetLocomotion(true, style);
  }

  /// Speeds in the body's own frame.
  void Tick(float forward_mps, float left_mps, float turn_left_rad_s) {
    heading_ += turn_left_rad_s * kTick_s;
    const Vec3 ahead{std::sin(heading_), 0, std::cos(heading_)}, left{ahead.z, 0, -ahead.x};
    place_ += (ahead * forward_mps + left * left_mps) * kTick_s;
    const world::BodyMotion motion{.forward_mps = forward_mps, .left_mps = left_mps, .heading_rad = heading_};
    animator_.Advance(&motion, kTick_s);
    std::vector<BonePose> bones = world::BodyBones(animator_.NowPose());
    const SkinPlace place{{place_, world::Turn({0, 1, 0}, heading_)}};
    if (holds_) feet_.Follow(place, kTick_s, bones);
    int point = 0;
    for (const int foot : {world::kLeftFoot, world::kRightFoot}) {
      const auto& ankle = bones[static_cast<std::size_t>(foot)];
      const auto& toe = bones[static_cast<std::size_t>(foot) + 1];
      Watch(point++, place.at.Apply(ankle.Apply({0, -Size::kAnkle, -Size::kHeel})));
      Watch(point++, place.at.Apply(toe.position - Vec3{0, 0.02f, 0}));
      // Legs keep their lengths.
      const Vec3 hip = bones[static_cast<std::size_t>(foot) - 2].position,
                 knee = bones[static_cast<std::size_t>(foot) - 1].position;
      EXPECT_NEAR(world::Distance(hip, knee), Size::kThigh, 1e-3f);
      EXPECT_NEAR(world::Distance(knee, ankle.position), Size::kShin, 1e-3f);
    }
    for (std::size_t bone = 0; bone < bones.size(); ++bone) {
      if (!last_.empty())
        most_jump_m_ = std::max(most_jump_m_, world::Distance(bones[bone].position, last_[bone].position));
    }
    last_ = std::move(bones);
  }

  /// Maximum distance that a heel or a ball slid on the ground.
  float most_slid_m() const { return most_slid_m_; }
  /// Maximum distance that a bone moved in the model from one tick to the next.
  float most_jump_m() const { return most_jump_m_; }
  void ForgetJumps() { most_jump_m_ = 0; }
  int steps() const { return steps_; }

 private:
  struct Watched {
    bool lies = false;
    Vec3 from;
  };

  void Watch(int point, Vec3 at) {
    constexpr float kLies_m = 0.010f;
    Watched& watched = watched_[static_cast<std::size_t>(point)];
    const bool lies = at.y < kLies_m;
    const Vec3 flat{at.x, 0, at.z};
    if (lies && !watched.lies) {
      watched.from = flat;
      ++steps_;
    }
    if (lies) most_slid_m_ = std::max(most_slid_m_, world::Distance(flat, watched.from));
    watched.lies = lies;
  }

  world::Animator animator_;
  FootPlant feet_;
  bool holds_;
  Vec3 place_;
  float heading_ = 0;
  std::array<Watched, 4> watched_;
  std::vector<BonePose> last_;
  float most_slid_m_ = 0, most_jump_m_ = 0;
  int steps_ = 0;
};

struct Motion {
  const char* name;
  LocomotionStyle style;
  float forward_mps, left_mps, turn_rad_s;
};

constexpr auto kReady = LocomotionStyle::kReady, kAim = LocomotionStyle::kAim, kCrouch = LocomotionStyle::kCrouch,
               kUnarmed = LocomotionStyle::kUnarmed;
constexpr Motion kMotions[] = {
    {"strolls", kReady, 0.4f, 0, 0},
    {"walks slowly", kReady, 0.8f, 0, 0},
    {"walks", kReady, 1.3f, 0, 0},
    {"walks fast", kReady, 2.0f, 0, 0},
    {"runs", kReady, 3.2f, 0, 0},
    {"runs fast", kReady, 4.5f, 0, 0},
    {"sprints", kReady, 6.0f, 0, 0},
    {"walks aiming", kAim, 1.2f, 0, 0},
    {"runs aiming", kAim, 3.0f, 0, 0},
    {"goes back", kReady, -1.0f, 0, 0},
    {"goes back fast", kAim, -2.0f, 0, 0},
    {"strafes left", kAim, 0, 1.0f, 0},
    {"strafes right", kAim, 0, -1.0f, 0},
    {"strafes slowly", kAim, 0, 0.5f, 0},
    {"goes aslant", kAim, 1.0f, 0.7f, 0},
    {"crouches", kCrouch, 1.0f, 0, 0},
    {"creeps", kCrouch, 0.5f, 0, 0},
    {"creeps back", kCrouch, -0.8f, 0, 0},
    {"turns slowly", kReady, 0, 0, 0.5f},
    {"turns", kReady, 0, 0, 1.5f},
    {"turns fast", kAim, 0, 0, -3.0f},
    {"walks round", kReady, 1.3f, 0, 0.6f},
    {"walks unarmed", kUnarmed, 1.3f, 0, 0},
    {"hurries unarmed", kUnarmed, 2.4f, 0, 0.3f},
    {"runs round", kReady, 3.2f, 0, -0.8f},
};

TEST(FootPlant, SolesThatLieOnTheGroundStayWhereTheyAre) {
  for (const Motion& motion : kMotions) {
    Walk walk(motion.style, true), loose(motion.style, false);
    for (int i = 0; i < 150; ++i) {
      walk.Tick(motion.forward_mps, motion.left_mps, motion.turn_rad_s);
      loose.Tick(motion.forward_mps, motion.left_mps, motion.turn_rad_s);
    }
    EXPECT_LT(walk.most_slid_m(), 0.02f) << motion.name;
    EXPECT_GT(loose.most_slid_m(), 0.05f) << motion.name << ": nothing to hold, so nothing is shown";
    EXPECT_GE(walk.steps(), 10) << motion.name;
    EXPECT_LT(walk.most_jump_m(), loose.most_jump_m() + 0.09f) << motion.name;
  }
}

TEST(FootPlant, WhoStartsAndStopsStandsStillInTheEnd) {
  for (const float speed : {0.5f, 1.3f, 3.2f}) {
    Walk walk(kReady, true);
    for (int round = 0; round < 4; ++round) {
      for (int i = 0; i < 40 + 7 * round; ++i) walk.Tick(speed, 0, 0);
      for (int i = 0; i < 60; ++i) walk.Tick(0, 0, 0);
    }
    EXPECT_LT(walk.most_slid_m(), 0.02f) << speed;
    walk.ForgetJumps();
    for (int i = 0; i < 30; ++i) walk.Tick(0, 0, 0);
    EXPECT_LT(walk.most_jump_m(), 0.01f) << speed;
  }
}

TEST(FootPlant, HoldsNothingOfWhoWasPutElsewhere) {
  FootPlant feet;
  const SkinPlace here{}, there{{{50, 0, 0}, {}}};
  world::Animator animator(world::SoldierRig());
  animator.SetLocomotion(true, kReady);
  const world::BodyMotion still;
  animator.Advance(&still, kTick_s);
  const std::vector<BonePose> wanted = world::BodyBones(animator.NowPose());
  std::vector<BonePose> bones = wanted;
  feet.Follow(here, kTick_s, bones);
  bones = wanted;
  feet.Follow(there, kTick_s, bones);
  for (std::size_t i = 0; i < bones.size(); ++i)
    EXPECT_LT(world::Distance(bones[i].position, wanted[i].position), 0.01f) << i;
}

}  // namespace
}  // namespace soarbox::viewer
