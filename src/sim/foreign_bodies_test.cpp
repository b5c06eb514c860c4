// SPDX-License-Identifier: BSD-2-Clause
#include "sim/foreign_bodies.h"

#include <gtest/gtest.h>

#include "world/state_hash.h"
#include "world/world.h"

namespace soarbox::sim {
namespace {

class Foreign : public testing::Test {
 protected:
  Foreign()
      : arena(world, [this](RunEvent event) { events.push_back(std::move(event)); }),
        bodies(world, arena, [this](RunEvent event) { events.push_back(std::move(event)); }) {
    // A floor to walk on.
    world.CreatePlane(100, 100);
  }

  static ForeignBodyInput Walker() {
    ForeignBodyInput input;
    input.id = "1:7:1";
    input.name = "visitor";
    input.team = "red";
    input.body = "soldier";
    input.position = {3, 0, 4};
    input.velocity = {2, 0, 0};
    input.heading_deg = 90;
    return input;
  }
  void Tick(int count = 1) {
    for (int i = 0; i < count; ++i) {
      world.BeginTick();
      arena.Step();
      bodies.Move();
      world.Step();
    }
  }
  const world::Agent& Body() { return *std::as_const(world).FindAgent(bodies.Find("1:7:1")); }

  world::World world;
  EventList events;
  Arena arena;
  ForeignBodies bodies;
};

TEST_F(Foreign, MovesOnAsItsOwnerSaid) {
  bodies.Apply(Walker(), BodyKinds());
  Tick(60);
  EXPECT_NEAR(Body().Position().x, 3 + 2 * 2, 0.1);
  EXPECT_NEAR(Body().Position().z, 4, 0.05);
  EXPECT_NEAR(Body().Forward().x, 1, 1e-3);
  EXPECT_EQ(Body().Team(), "red");
  EXPECT_EQ(Body().kind(), kForeignKind);
}

TEST_F(Foreign, ASmallCorrectionIsMadeGoodSmoothlyAndALargeOneAtOnce) {
  bodies.Apply(Walker(), BodyKinds());
  Tick(30);
  ForeignBodyInput next = Walker();
  next.position = {5, 0, 5};
  next.velocity = {};
  bodies.Apply(next, BodyKinds());
  Tick(1);
  EXPECT_NEAR(Body().Position().z, 4, 0.2);
  Tick(30);
  EXPECT_NEAR(Body().Position().z, 5, 0.05);
  next.position = {40, 0, 5};
  bodies.Apply(next, BodyKinds());
  Tick(1);
  EXPECT_NEAR(Body().Position().x, 40, 0.1);
}

TEST_F(Foreign, WhoLeavesIsHiddenAndMayComeBack) {
  bodies.Apply(Walker(), BodyKinds());
  Tick(1);
  const world::EntityId before = bodies.Find("1:7:1");
  bodies.Apply(ForeignGoneInput{"1:7:1"});
  Tick(1);
  EXPECT_EQ(bodies.Find("1:7:1"), world::kNoEntity);
  EXPECT_LE(std::as_const(world).FindAgent(before)->Health(), 0);
  EXPECT_LT(std::as_const(world).FindAgent(before)->Position().y, -10);
  bodies.Apply(Walker(), BodyKinds());
  Tick(1);
  EXPECT_GT(Body().Health(), 0);
}

TEST_F(Foreign, OurShotsHurtItOnlyWhenItsOwnerSaysSo) {
  bodies.Apply(Walker(), BodyKinds());
  world.FindAgent(bodies.Find("1:7:1"))->SetHealth(40);
  Tick(1);
  EXPECT_EQ(Body().Health(), 100);
  ForeignBodyInput dead = Walker();
  dead.health = 0;
  bodies.Apply(dead, BodyKinds());
  Tick(2);
  EXPECT_LE(Body().Health(), 0);
}

TEST_F(Foreign, ItsShotsHurtOurs) {
  bodies.Apply(Walker(), BodyKinds());
  world::AgentDef def;
  def.name = "guard";
  const world::EntityId guard = world.CreateAgent(def);
  arena.Add(guard, BodyKinds().front());
  world.FindAgent(guard)->SetPosition({10, 1, 10});
  bodies.Apply(ForeignShotInput{"1:7:1", "guard", 30, 0, {3, 1, 4}, {10, 1, 10}});
  EXPECT_EQ(world.FindAgent(guard)->Health(), 70);
  // A detonation at a distance of two metres, with a radius of four, causes half of its damage.
  bodies.Apply(ForeignShotInput{"1:7:1", "", 40, 4, {3, 1, 4}, {12, 1, 10}});
  EXPECT_NEAR(world.FindAgent(guard)->Health(), 50, 0.5);
  ASSERT_FALSE(arena.Find(guard)->happenings().empty());
  EXPECT_EQ(arena.Find(guard)->happenings().front().type, "hit");
}

TEST_F(Foreign, AnUnknownKindOfBodyAndAShooterWhoIsNotThereAreNoFault) {
  ForeignBodyInput input = Walker();
  input.body = "dragon";
  bodies.Apply(input, BodyKinds());
  bodies.Apply(ForeignShotInput{"9:9:9", "nobody", 30, 0, {}, {}});
  bodies.Apply(ForeignGoneInput{"9:9:9"});
  bodies.Apply(ForeignMessageInput{"9:9:9", "", "x", "y"});
  Tick(1);
  EXPECT_TRUE(arena.board().messages().empty());
}

TEST_F(Foreign, WhatItSaysReachesTheTeamThatItNames) {
  bodies.Apply(Walker(), BodyKinds());
  bodies.Apply(ForeignMessageInput{"1:7:1", "blue", "enemy-seen", "name x range 12"});
  ASSERT_EQ(arena.board().messages().size(), 1u);
  const world::Message& message = arena.board().messages().front();
  EXPECT_EQ(message.team, "blue");
  EXPECT_EQ(message.from, bodies.Find("1:7:1"));
  ASSERT_EQ(message.fields.size(), 2u);
  EXPECT_EQ(message.fields[1].name, "range");
}

}  // namespace
}  // namespace soarbox::sim
