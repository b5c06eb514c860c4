// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/software_picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "model/model.h"

namespace soarbox::viewer {
namespace {

using picture::Image;
using world::Vec3;

/// A plain with a red box of 2 m in its centre.
world::SceneSnapshot SomeScene() {
  world::SceneSnapshot scene;
  world::DrawableSnapshot ground;
  ground.id = 1;
  ground.shape = world::ShapeKind::kPlane;
  ground.size = {60, 0, 60};
  ground.material = std::string("White");
  scene.drawables.push_back(ground);
  world::DrawableSnapshot box;
  box.id = 2;
  box.shape = world::ShapeKind::kBox;
  box.size = {2, 2, 2};
  box.position = {0, 1, 0};
  box.material = std::string("Red");
  scene.drawables.push_back(box);
  return scene;
}

bool IsReddish(const Image& image, int x, int y) {
  const std::uint8_t* const pixel = image.At(x, y);
  return pixel[0] > 1.8 * pixel[1] && pixel[0] > 60;
}

int Reddish(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += IsReddish(image, x, y) ? 1 : 0;
  return count;
}

TEST(SoftwarePicture, APlanShowsThingsWhereTheyAreAndAsLargeAsTheyAre) {
  SoftwarePictures pictures(200, 100);
  // 20 m high and 40 m wide: 5 px per m.
  const SoftwareCamera camera = CameraOver({{-10, 0, -7}, {10, 0, 7}}, 2, true);
  EXPECT_FLOAT_EQ(camera.high_m, 20);
  world::SceneSnapshot scene = SomeScene();
  const Image image = pictures.Draw(scene, camera);
  EXPECT_TRUE(IsReddish(image, 100, 50));
  EXPECT_NEAR(Reddish(image), 100, 12);
  EXPECT_FALSE(IsReddish(image, 108, 50));
  // x is to the right and z down.
  world::SceneSnapshot moved = SomeScene();
  moved.drawables = {};
  world::DrawableSnapshot box;
  box.shape = world::ShapeKind::kBox;
  box.size = {2, 2, 2};
  box.position = {6, 1, 4};
  box.material = std::string("Red");
  moved.drawables.push_back(box);
  EXPECT_TRUE(IsReddish(pictures.Draw(moved, camera), 130, 70));
}

/// A red square of 1 m that faces along z, moved by one bone. The model is stored under this key.
std::string RedSquareOnABone() {
  model::Model model;
  const Vec3 corners[] = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
  for (const Vec3 corner : corners) {
    model.corners.push_back({corner, {0, 0, 1}, 1, 0, 0});
    model.skins.push_back({corner, {0, 0, 1}, {}, {1, 0, 0, 0}});
  }
  model.indices = {0, 1, 2, 0, 2, 3};
  model.min = corners[0];
  model.max = corners[2];
  model.joints = {{0, {}}};
  model.rig.skeleton.AddToParent("bone", -1, {});
  return model::KeepModel("square.glb", std::move(model));
}

TEST(SoftwarePicture, BonesMoveAndStretchAModel) {
  SoftwarePictures pictures(200, 100);
  SoftwareCamera camera;
  camera.eye = {0, 1, 10};
  camera.ahead = {0, 0, -1};
  camera.high_m = 10;  // 10 px per m.
  world::SceneSnapshot scene;
  world::DrawableSnapshot square;
  square.mesh = RedSquareOnABone();
  square.position = {0, 1, 0};
  square.bones = std::vector<world::BonePose>{{{4, 0, 0}, {}, {2, 1, 1}}};
  scene.drawables.push_back(square);
  const Image image = pictures.Draw(scene, camera);
  EXPECT_FALSE(IsReddish(image, 100, 50));
  EXPECT_TRUE(IsReddish(image, 140, 50));
  EXPECT_TRUE(IsReddish(image, 148, 50));
  EXPECT_NEAR(Reddish(image), 200, 30);
}

TEST(SoftwarePicture, WhatIsNearerHidesWhatIsFarther) {
  SoftwarePictures pictures(100, 100);
  SoftwareCamera camera;
  camera.eye = {0, 1, 10};
  camera.ahead = {0, 0, -1};
  world::SceneSnapshot scene = SomeScene();
  EXPECT_TRUE(IsReddish(pictures.Draw(scene, camera), 50, 50));
  world::DrawableSnapshot wall;
  wall.id = 3;
  wall.shape = world::ShapeKind::kBox;
  wall.size = {6, 6, 1};
  wall.position = {0, 1, 5};
  wall.material = std::string("Blue");
  scene.drawables.push_back(wall);
  EXPECT_EQ(Reddish(pictures.Draw(scene, camera)), 0);
  // From the other side, the wall is behind the box.
  camera.eye = {0, 1, -10};
  camera.ahead = {0, 0, 1};
  EXPECT_TRUE(IsReddish(pictures.Draw(scene, camera), 50, 50));
}

TEST(SoftwarePicture, WhatIsBehindTheCameraIsCutOff) {
  SoftwarePictures pictures(100, 100);
  SoftwareCamera camera;
  camera.eye = {0, 5, 0};
  camera.ahead = {0, 0, -1};
  // The ground goes from far behind to far ahead.
  const Image image = pictures.Draw(SomeScene(), camera);
  const std::uint8_t* const below = image.At(50, 95);
  EXPECT_LT(std::abs(below[0] - below[2]), 12) << "the white ground, not the sky";
  EXPECT_GT(image.At(50, 5)[2], image.At(50, 5)[0] + 15) << "the sky";
}

TEST(SoftwarePicture, ThingsCastShadowsOnTheGround) {
  SoftwarePictures pictures(200, 200);
  const SoftwareCamera camera = CameraOver({{-7, 0, -7}, {7, 0, 7}}, 1, true);
  world::SceneSnapshot scene = SomeScene();
  const Image image = pictures.Draw(scene, camera);
  int dark = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      dark += !IsReddish(image, x, y) && image.At(x, y)[1] < 0.85 * image.At(195, 195)[1] ? 1 : 0;
  EXPECT_GT(dark, 100);
  EXPECT_LT(dark, 4000);
}

TEST(SoftwarePicture, TheSameSceneGivesTheSamePixels) {
  const SoftwareCamera camera = CameraOver({{-5, 0, -5}, {5, 0, 5}}, 1.6f, false);
  SoftwarePictures once(160, 100), again(160, 100);
  const Image first = once.Draw(SomeScene(), camera);
  EXPECT_EQ(first.rgb, again.Draw(SomeScene(), camera).rgb);
  EXPECT_EQ(first.rgb, once.Draw(SomeScene(), camera).rgb);
}

TEST(SoftwarePicture, TheCameraSeesAllPlaces) {
  const std::vector<Vec3> places = {{-30, 0, -12}, {25, 0, 18}, {3, 2, 40}};
  for (const float aspect : {0.6f, 1.0f, 1.78f, 3.0f}) {
    for (const bool is_plan : {false, true}) {
      SoftwareRaster raster(static_cast<int>(200 * aspect), 200);
      raster.Begin(CameraOver(places, aspect, is_plan));
      for (const Vec3 place : places) {
        const auto seen = raster.Project(place);
        ASSERT_TRUE(seen);
        EXPECT_GE(seen->x, 0) << aspect;
        EXPECT_LE(seen->x, 200 * aspect);
        EXPECT_GE(seen->y, 0) << aspect;
        EXPECT_LE(seen->y, 200);
      }
    }
  }
}

}  // namespace
}  // namespace soarbox::viewer
