// SPDX-License-Identifier: BSD-2-Clause
#include "app/shape_contents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "viewer/drawable_mesh.h"
#include "world/animation/rig.h"

namespace soarbox::app {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using world::DrawableSnapshot;
using world::ShapeKind;

DrawableSnapshot Box(world::Vec3 size, const char* material = "") {
  DrawableSnapshot box;
  box.shape = ShapeKind::kBox;
  box.size = size;
  box.material = std::string(material);
  return box;
}

DrawableSnapshot Mesh(const char* name, const char* material = "") {
  DrawableSnapshot mesh;
  mesh.mesh = std::string(name);
  mesh.material = std::string(material);
  return mesh;
}

world::SceneSnapshot SceneOf(std::vector<DrawableSnapshot> drawables) {
  world::SceneSnapshot scene;
  std::uint32_t id = 0;
  for (DrawableSnapshot& drawable : drawables) {
    drawable.id = ++id;
    scene.drawables.push_back(std::move(drawable));
  }
  return scene;
}

std::vector<std::string> NamesIn(const std::vector<ShapeContents::Told>& told) {
  std::vector<std::string> names;
  for (const ShapeContents::Told& one : told) names.push_back(one.name);
  return names;
}

TEST(ShapeContents, AShapeIsCalledAsThePageCallsIt) {
  // web/src/scene/scene.test.ts expects the same key.
  EXPECT_EQ(ShapeKey(Box({1, 2, 3}), false), "1.0.3f800000.40000000.40400000.3f800000.3f800000.");
  DrawableSnapshot sheep = Box({0.3f, 1, 0}, "Soarbox/Sheep");
  sheep.shape = ShapeKind::kCapsule;
  EXPECT_EQ(ShapeKey(sheep, true), "2.1.3e99999a.3f800000.0.3f800000.3f800000.Soarbox/Sheep");
  EXPECT_EQ(ShapeKey(Box({1, 2, 3}, "White"), false), ShapeKey(Box({1, 2, 3}), false));
  EXPECT_EQ(ShapeKey(Mesh("a.mesh"), false), "mesh/a.mesh");
}

TEST(ShapeContents, EachShapeIsToldOnce) {
  ShapeContents shapes;
  EXPECT_THAT(shapes.New(SceneOf({Box({1, 1, 1}), Box({1, 1, 1}, "Red"), Box({1, 1, 2})})), SizeIs(2));
  EXPECT_THAT(shapes.New(SceneOf({Box({1, 1, 1}), Box({1, 1, 2})})), IsEmpty());
  EXPECT_THAT(shapes.New(SceneOf({Box({3, 1, 2}), Mesh("no such.mesh")})), SizeIs(2));
}

TEST(ShapeContents, ABodyComesWithItsBonesAndInTheUniformThatItWears) {
  ShapeContents shapes;
  const auto told = shapes.New(SceneOf({Mesh("models/soarbox/soldier.mesh", "SF_Soldier_Body_Dark")}));
  EXPECT_THAT(NamesIn(told), ElementsAre("shapes:mesh/models/soarbox/soldier.mesh", "shapes:body/dark"));
  EXPECT_EQ(told[0].content["body"], "body/soldier");
  EXPECT_THAT(told[1].content["bones"], SizeIs(world::SoldierRig().skeleton.count()));
  const auto size = [&](const char* level) { return told[1].content[level].get<std::string>().size(); };
  EXPECT_GT(size("fine"), size("coarse"));
  EXPECT_GT(size("coarse"), size("tiny"));
}

TEST(ShapeContents, AModelThatMovesComesWithItsMotion) {
  model::Model model;
  for (const float x : {0.0f, 1.0f, 2.0f}) {
    model.corners.push_back({{x, 0, 0}, {0, 0, 1}});
    model.skins.push_back({{x, 0, 0}, {0, 0, 1}, {}, {1, 0, 0, 0}});
  }
  model.indices = {0, 1, 2};
  model::Model still = model;
  still.skins.clear();
  model.joints = {{0, {}}};
  model.rig.skeleton.AddToParent("bone", -1, {});
  const std::string moving = model::KeepModel("moves.glb", model), not_moving = model::KeepModel("still.glb", still);
  ShapeContents contents;
  const auto told = contents.New(SceneOf({Mesh(moving.c_str()), Mesh(not_moving.c_str())}));
  ASSERT_THAT(NamesIn(told), ElementsAre("shapes:mesh/" + moving, "shapes:mesh/" + not_moving));
  EXPECT_TRUE(told[0].content.contains("motion"));
  EXPECT_EQ(told[0].content["material"], "Soarbox/Model");
  EXPECT_FALSE(told[1].content.contains("motion"));
}

TEST(ShapeContents, ThePlainComesWithWhatStandsAroundIt) {
  DrawableSnapshot plain = Box({200, 0, 200});
  plain.shape = ShapeKind::kPlane;
  ShapeContents shapes;
  EXPECT_THAT(NamesIn(shapes.New(SceneOf({plain}))),
              ElementsAre(testing::HasSubstr("shapes:4.0."), "shapes:backdrop/hills", "shapes:backdrop/trees",
                          "shapes:backdrop/fence"));
}

TEST(ShapeContents, NobodyIsToldOfShapesWithoutEnd) {
  ShapeContents shapes;
  std::size_t count = 0;
  for (std::size_t i = 0; i < ShapeContents::kMost + 50; ++i)
    count += shapes.New(SceneOf({Box({1, 1, 1 + 0.001f * static_cast<float>(i)})})).size();
  EXPECT_EQ(count, ShapeContents::kMost);
}

TEST(ShapeContents, WhatHasNoSizeIsAShapeLikeOthers) {
  ShapeContents shapes;
  DrawableSnapshot odd = Box({-1, 0, std::numeric_limits<float>::quiet_NaN()});
  EXPECT_THAT(shapes.New(SceneOf({odd})), SizeIs(1));
}

}  // namespace
}  // namespace soarbox::app
