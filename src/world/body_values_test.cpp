// SPDX-License-Identifier: BSD-2-Clause
#include "world/body_values.h"

#include <gtest/gtest.h>

#include <limits>

#include "world/world.h"

namespace soarbox::world {
namespace {

TEST(BodyValues, WhatABodyCanHaveIsTakenAsItIs) {
  EXPECT_EQ(BodySize("width", 2.5f).value, 2.5f);
  EXPECT_EQ(BodySize("width", 2.5f).problem, "");
  EXPECT_EQ(BodyMass(0).problem, "");
}

TEST(BodyValues, OthersAreLimitedAndSaidToBe) {
  EXPECT_EQ(BodySize("width", -3).problem, "a width of -3 m is not possible: 0.001 m is used");
  EXPECT_EQ(BodySize("radius", 1e9f).value, 1e5f);
  EXPECT_EQ(BodyMass(-1).problem, "a mass of -1 kg is not possible: 0 kg is used");
  EXPECT_EQ(BodyMass(std::numeric_limits<float>::quiet_NaN()).value, 0);
}

TEST(BodyValues, TheWorldTakesWhatTheySay) {
  World world;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  world.CreatePlane(nan, -1);
  for (const EntityId id : {world.CreateBox(-3, nan, 1e30f), world.CreatePhysicsSphere(nan),
                            world.CreatePhysicsCapsule(nan, -1), world.CreateCapsule(-1, 1e30f)}) {
    world.FindObject(id)->SetPosition({0, 1, 0});
    world.FindObject(id)->SetMass(1e30f);
    EXPECT_EQ(world.FindObject(id)->Mass(), BodyMass(1e30f).value);
  }
  for (int i = 0; i < 10; ++i) {
    world.BeginTick();
    world.Step();
  }
  for (const EntityId id : world.ObjectIds()) EXPECT_TRUE(IsFinite(world.FindObject(id)->Position()));
}

}  // namespace
}  // namespace soarbox::world
