// SPDX-License-Identifier: BSD-2-Clause
#include "sim/bearing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "world/animation/animator.h"
#include "world/animation/soldier_skeleton.h"
#include "world/world.h"

namespace soarbox::sim {
namespace {

/// A soldier with a rifle who stands still.
class Sentry {
 public:
  explicit Sentry(bool is_armed = true) {
    world_.CreatePlane(100, 100);
    id_ = world_.CreateAgent({});
    figure_ = world_.scene().CreateMesh(world_.NodeOf(id_), "models/soarbox/soldier.mesh");
    const world::NodeId rifle = world_.scene().CreateMesh(world_.NodeOf(id_), "models/soarbox/rifle.mesh");
    world_.scene().AttachToBone(figure_, world::kRightHand, rifle, world::RifleHold::kAttachOffset,
                                world::FromRotationVector(world::RifleHold::kAttachRotation_deg));
    bearing_.SetFigure(figure_);
    deeds.is_armed = is_armed;
    deeds.rounds = 10;
    Tick(30);
  }
  void Tick(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      world_.BeginTick();
      bearing_.Show(world_, deeds);
      world_.Step();
    }
  }
  /// Direction of the rifle, and how far the muzzle is below the head.
  world::Vec3 Barrel() const { return Rotate(Muzzle().orientation, {1, 0, 0}); }
  float BelowHead() const { return world_.scene().BoneInWorld(figure_, "b_Head1")->position.y - Muzzle().position.y; }
  bool Plays(const char* clip) {
    const world::Animator& animator = *world_.scene().AnimatorOf(figure_);
    return animator.state(static_cast<std::size_t>(animator.rig().FindClip(clip))).enabled;
  }
  world::World& world() { return world_; }
  Bearing& bearing() { return bearing_; }

  Bearing::Deeds deeds;

 private:
  world::BonePose Muzzle() const { return world_.scene().BoneInWorld(figure_, "b_muzzle").value(); }

  world::World world_;
  world::EntityId id_{};
  world::NodeId figure_{};
  Bearing bearing_;
};

TEST(Bearing, WhoShootsPointsTheRifleAheadAndLowersItAMomentAfter) {
  Sentry sentry;
  EXPECT_LT(sentry.Barrel().z, 0.8f);
  sentry.deeds.shoots = true;
  sentry.Tick(15);
  EXPECT_GT(sentry.Barrel().z, 0.98f);
  EXPECT_NEAR(sentry.BelowHead(), 0.15f, 0.1f);
  sentry.deeds.shoots = false;
  sentry.Tick(30);
  EXPECT_GT(sentry.Barrel().z, 0.98f) << "the next shot may come";
  sentry.Tick(45);
  EXPECT_LT(sentry.Barrel().z, 0.8f);
}

TEST(Bearing, EachShotKicksAndALoadedWeaponComesUpAgain) {
  Sentry sentry;
  sentry.deeds.shoots = true;
  sentry.Tick(15);
  --sentry.deeds.rounds;
  sentry.Tick(1);
  EXPECT_TRUE(sentry.Plays("stand_fire_one_shot"));
  sentry.Tick(20);
  EXPECT_FALSE(sentry.Plays("stand_fire_one_shot"));
  sentry.deeds.reloads = true;
  sentry.Tick(30);
  EXPECT_TRUE(sentry.Plays("stand_reload"));
  sentry.deeds.reloads = false;
  sentry.deeds.rounds = 10;
  sentry.Tick(8);
  EXPECT_FALSE(sentry.Plays("stand_reload"));
}

TEST(Bearing, WhoIsHitFlinchesAndTheDeadJustFall) {
  Sentry sentry;
  sentry.deeds.health = 60;
  sentry.Tick(1);
  EXPECT_TRUE(sentry.Plays("stand_hit"));
  sentry.bearing().End(sentry.world());
  EXPECT_FALSE(sentry.Plays("stand_hit"));
  sentry.deeds.stance = "crouching";
  --sentry.deeds.rounds;
  sentry.Tick(1);
  EXPECT_TRUE(sentry.Plays("crouch_fire_one_shot"));
}

}  // namespace
}  // namespace soarbox::sim
