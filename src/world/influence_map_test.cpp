// SPDX-License-Identifier: BSD-2-Clause
#include "world/influence_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "world/triangle_box.h"
#include "world/world.h"

namespace soarbox::world {
namespace {

/// A map over a floor of 20 by 20 m: cells of 2 by 2 m, 1 m high.
class InfluenceMapTest : public testing::Test {
 protected:
  InfluenceMapTest() {
    const EntityId id = world_.CreateBox(20, 1, 20);
    world_.FindObject(id)->SetMass(0);
    world_.FindObject(id)->SetPosition({0, -0.5f, 0});
    EXPECT_TRUE(world_.CreateNavigationMesh("default", {}).ok());
    EXPECT_TRUE(world_.CreateInfluenceMap("default", {2, 1, {}, {}}).ok());
  }
  InfluenceMap& Map() { return *world_.influence(); }
  World world_;
};

constexpr Vec3 kHere{0.5f, 0.1f, 0.5f};
constexpr Vec3 kBeside{2.5f, 0.1f, 0.5f};
constexpr Vec3 kAcross{2.5f, 0.1f, 2.5f};
constexpr Vec3 kTwoAway{4.5f, 0.1f, 0.5f};

TEST_F(InfluenceMapTest, CellsHoldClampedValuesInLayersOfTheirOwn) {
  EXPECT_TRUE(Map().Set(0, kHere, 0.5f));
  EXPECT_TRUE(Map().Set(1, kHere, -7));
  EXPECT_EQ(Map().Get(0, kHere), 0.5f);
  EXPECT_EQ(Map().Get(1, kHere), -1);
  EXPECT_EQ(Map().Get(2, kHere), 0);
  EXPECT_TRUE(Map().Set(0, kHere, 0.25f)) << "a value is overwritten";
  EXPECT_EQ(Map().Get(0, kHere), 0.25f);
  Map().Clear(0);
  EXPECT_EQ(Map().Get(0, kHere), 0);
  EXPECT_EQ(Map().Get(1, kHere), -1);
}

TEST_F(InfluenceMapTest, WhatIsOutOfRangeIsIgnored) {
  EXPECT_FALSE(Map().Set(10, kHere, 1));
  EXPECT_FALSE(Map().Set(-1, kHere, 1));
  EXPECT_FALSE(Map().Set(0, {500, 0, 0}, 1));
  EXPECT_FALSE(Map().Set(0, {0.5f, 9, 0.5f}, 1)) << "above the mesh";
  EXPECT_FALSE(Map().Set(0, kHere, std::nanf("")));
  EXPECT_FALSE(Map().Set(0, {std::nanf(""), 0, 0}, 1));
  EXPECT_EQ(Map().Get(12, kHere), 0);
  Map().Spread(99);
  Map().Clear(-5);
  Map().Draw(10, {}, {}, {});
}

TEST_F(InfluenceMapTest, FloorsAtTheBorderOfTwoCellsUseOne) {
  const EntityId id = world_.CreateBox(20, 1, 20);  // A second floor, three cells above the first.
  world_.FindObject(id)->SetMass(0);
  world_.FindObject(id)->SetPosition({0, 2.5f, 0});
  ASSERT_TRUE(world_.CreateNavigationMesh("default", {}).ok());
  const int one_floor = Map().used_cells();
  ASSERT_TRUE(world_.CreateInfluenceMap("default", {2, 1, {}, {}}).ok());
  EXPECT_LE(Map().used_cells(), 2 * one_floor + 2);
  EXPECT_TRUE(Map().Set(0, {0.5f, 3.05f, 0.5f}, 1));
}

TEST_F(InfluenceMapTest, SpreadingLosesTheFalloffByDistance) {
  Map().SetFalloff(0, 0.2f);
  Map().Set(0, kHere, 1);
  Map().Spread(0);
  EXPECT_FLOAT_EQ(Map().Get(0, kHere), 1);
  EXPECT_NEAR(Map().Get(0, kBeside), 0.8f, 1e-5f);
  EXPECT_NEAR(Map().Get(0, kAcross), std::pow(0.8f, std::sqrt(2.0f)), 1e-5f);
  EXPECT_NEAR(Map().Get(0, kTwoAway), 0.64f, 1e-5f);
}

TEST_F(InfluenceMapTest, OppositeInfluencesMeetAndInertiaSlows) {
  Map().SetFalloff(0, 0.5f);
  Map().Set(0, kHere, 1);
  Map().Set(0, kTwoAway, -1);
  Map().Spread(0);
  EXPECT_NEAR(Map().Get(0, kBeside), 0, 0.1f) << "between the two";
  Map().SetFalloff(1, 0.98f);  // One pass.
  Map().SetInertia(1, 0.5f);
  Map().Set(1, kHere, 1);
  Map().Spread(1);
  EXPECT_NEAR(Map().Get(1, kBeside), 0.01f, 1e-4f);
  Map().Set(2, kHere, 1);
  Map().Spread(2);
  EXPECT_FLOAT_EQ(Map().Get(2, {-8, 0.1f, -8}), 1) << "without falloff an influence reaches all cells within 20";
}

TEST_F(InfluenceMapTest, ColorsStayUntilTheNextDrawing) {
  EXPECT_TRUE(world_.Snapshot().triangles.empty());
  Map().Set(0, kHere, 0.5f);
  Map().Set(0, kTwoAway, -1);
  Map().Draw(0, {1, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 1, 1});
  Map().Clear(0);
  const SceneSnapshot snapshot = world_.Snapshot();
  EXPECT_EQ(snapshot.triangles.size(), 2u * static_cast<std::size_t>(Map().used_cells()));
  EXPECT_EQ(snapshot.lines.size(), 4u * static_cast<std::size_t>(Map().used_cells()));
  int half_red = 0, blue = 0;
  for (const TriangleSnapshot& triangle : snapshot.triangles) {
    half_red += triangle.color == Color{0.5f, 0, 0, 1};
    blue += triangle.color == Color{0, 0, 1, 1};
  }
  EXPECT_EQ(half_red, 2);
  EXPECT_EQ(blue, 2);
  Map().SetVisible(false);
  EXPECT_TRUE(world_.Snapshot().triangles.empty());
}

TEST_F(InfluenceMapTest, ValuesArePartOfTheWorldsHash) {
  const std::uint64_t before = world_.Hash();
  Map().Set(3, kHere, 0.5f);
  EXPECT_NE(world_.Hash(), before);
  Map().Clear(3);
  EXPECT_EQ(world_.Hash(), before);
}

TEST_F(InfluenceMapTest, CellsThatCannotBeAreRefusedAndTheOldMapStays) {
  Map().Set(0, kHere, 1);
  const auto message = [&](const InfluenceConfig& config) {
    const Result<void> made = world_.CreateInfluenceMap("default", config);
    return made.ok() ? "no error" : made.error().message;
  };
  EXPECT_EQ(message({0, 0, {}, {}}), "CellWidth and CellHeight must be from 0.01 to 1000 m");
  EXPECT_EQ(message({0.01f, 0.01f, {}, {}}), "the influence map would have more than 1 million cells");
  EXPECT_EQ(message({1, 1, {std::nanf(""), 0, 0}, {}}), "an offset of the boundary is not finite");
  EXPECT_EQ(message({1, 1, {-1e9f, 0, 0}, {}}), "the influence map would have more than 1 million cells");
  EXPECT_EQ(message({1, 1, {1e9f, 0, 0}, {}}), "no error") << "one cell, far from everything";
  EXPECT_EQ(world_.influence()->used_cells(), 0);
  EXPECT_FALSE(world_.CreateInfluenceMap("nowhere", {1, 1, {}, {}}).ok());
  EXPECT_NE(world_.influence(), nullptr);
}

TEST(TriangleBox, TouchesWhereAPointIsShared) {
  const std::array<Vec3, 3> triangle{{{0, 0, 0}, {4, 0, 0}, {0, 0, 4}}};
  EXPECT_TRUE(TriangleTouchesBox(triangle, {1, 0, 1}, {0.5f, 0.5f, 0.5f}));
  EXPECT_TRUE(TriangleTouchesBox(triangle, {0, 0, 0}, {9, 9, 9}));
  EXPECT_FALSE(TriangleTouchesBox(triangle, {3, 0, 3}, {0.5f, 0.5f, 0.5f}))
      << "within its bounds, beyond its long side";
  EXPECT_FALSE(TriangleTouchesBox(triangle, {1, 2, 1}, {0.5f, 0.5f, 0.5f}));
  EXPECT_FALSE(TriangleTouchesBox(triangle, {-2, 0, 1}, {0.5f, 0.5f, 0.5f}));
}

}  // namespace
}  // namespace soarbox::world
