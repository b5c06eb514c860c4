// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/camera_keeper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sim/scenario.h"
#include "sim/simulation.h"
#include "viewer/camera_rig.h"
#include "viewer/picking.h"

namespace soarbox::viewer {
namespace {

using world::Vec3;

constexpr float kFrame_s = 1.0f / 30;

FramedBody BodyAt(Vec3 position, Vec3 velocity = {}) {
  return {position, velocity, 0.35f, 1.75f};
}

world::AgentSnapshot AgentAt(std::uint32_t id, Vec3 position) {
  world::AgentSnapshot agent;
  agent.id = id;
  agent.position = position;
  agent.height_m = 1.75f;
  agent.radius_m = 0.35f;
  return agent;
}

/// A camera that follows a world as in the window, tick by tick.
class Watcher {
 public:
  Watcher(int width, int height) : width_(width), height_(height) {}

  void Show(const world::SceneSnapshot& scene, const world::OverlaySnapshot& overlays) {
    std::vector<FramedBody> bodies;
    std::vector<const world::AgentSnapshot*> agents;
    std::vector<Vec3> places;
    for (const auto& agent : scene.agents) {
      if (!agent.alive) continue;
      agents.push_back(&agent);
      bodies.push_back({agent.position, agent.velocity, agent.radius_m, agent.height_m});
    }
    for (const auto& place : overlays.places)
      if (place.kind != world::PlaceSnapshot::Kind::kThing) places.push_back(place.position);
    if (!std::exchange(has_begun_, true)) {
      camera_.MoveTo(scene.camera);
      camera_.Frame(agents, Aspect(), true, places, false, SceneryAround(scene, places));
      camera_.Arrive();
      camera_.BeginKeeping();
    }
    camera_.Keep(bodies, places, Aspect(), kFrame_s, SceneryAround(scene, places));
    const Vec3 before = camera_.pose().position;
    camera_.Update({}, kFrame_s, nullptr, static_cast<float>(height_));
    const Vec3 step = camera_.pose().position - before;
    roughest_mps2_ = std::max(roughest_mps2_, world::Length(step - last_step_) / (kFrame_s * kFrame_s));
    last_step_ = step;
  }

  /// Returns the agents that are not completely in the picture, and the height of the smallest one.
  std::string Missing(const world::SceneSnapshot& scene, float& smallest_px) const {
    const Projection view(camera_.pose(), width_, height_);
    const auto width = static_cast<float>(width_), height = static_cast<float>(height_);
    std::string missing;
    smallest_px = height;
    for (const auto& agent : scene.agents) {
      if (!agent.alive) continue;
      const Vec3 half{0, agent.height_m / 2, 0};
      const auto head = view.Project(agent.position + half), feet = view.Project(agent.position - half);
      const bool is_in = head && feet && head->x > 0 && head->x < width && head->y > 0 && feet->y < height;
      if (!is_in) missing += " " + agent.name;
      if (head && feet) smallest_px = std::min(smallest_px, std::hypot(feet->y - head->y, feet->x - head->x));
    }
    return missing;
  }
  float roughest_mps2() const { return roughest_mps2_; }
  CameraRig& camera() { return camera_; }

 private:
  float Aspect() const { return static_cast<float>(width_) / static_cast<float>(height_); }

  int width_, height_;
  CameraRig camera_;
  bool has_begun_ = false;
  Vec3 last_step_;
  float roughest_mps2_ = 0;
};

class Scenarios : public ::testing::TestWithParam<std::string> {};

TEST_P(Scenarios, KeepTheirAgentsInThePictureFromTheFirstSecondOn) {
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = sim::FindScenario(GetParam(), {root + "/scenarios", root + "/media"});
  ASSERT_TRUE(scenario.ok()) << scenario.error().message;
  const auto simulation = std::move(sim::Simulation::Create(*scenario, {}).value());
  // The entire window, and the space that panels leave.
  Watcher large(1280, 720), small(620, 400);
  for (int tick = 0; tick <= 900; ++tick) {
    if (tick > 0) {
      simulation->Tick();
      simulation->TakeEvents();
    }
    const world::SceneSnapshot scene = simulation->Snapshot();
    const world::OverlaySnapshot overlays = simulation->Overlays({});
    for (Watcher* watcher : {&large, &small}) watcher->Show(scene, overlays);
    if (tick != 0 && tick != 30 && tick != 300 && tick != 900) continue;
    for (Watcher* watcher : {&large, &small}) {
      float smallest_px = 0;
      EXPECT_EQ(watcher->Missing(scene, smallest_px), "") << "at " << tick / 30 << " s";
      EXPECT_GT(smallest_px, watcher == &large ? 5 : 2.5f) << "specks at " << tick / 30 << " s";
    }
  }
  for (Watcher* watcher : {&large, &small}) EXPECT_LT(watcher->roughest_mps2(), 400) << "the camera jerks";
}

INSTANTIATE_TEST_SUITE_P(Shipped, Scenarios,
                         ::testing::Values("animation", "crowd/crowd_100.lua", "decisions", "decisions/tree.lua",
                                           "decisions/behavior_tree.lua", "knowledge", "mind_body", "movement",
                                           "navigation", "perception", "soar_evade", "soar_flee", "soar_follow",
                                           "soar_hallway", "soar_obstacles", "soar_path", "soar_pursue", "soar_seek",
                                           "soar_skirmish", "soar_wander", "tactics", "thesis", "thesis/gather.lua",
                                           "thesis/mixed.lua", "thesis/soar_leader.lua"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

/// Number of walls and figures that are completely in the picture, and their total number.
std::pair<int, int> SceneryIn(const std::string& name, int tick) {
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = sim::FindScenario(name, {root + "/scenarios", root + "/media"});
  if (!scenario.ok()) return {0, 0};
  const auto simulation = std::move(sim::Simulation::Create(*scenario, {}).value());
  Watcher watcher(1280, 720);
  std::vector<FramedBody> scenery;
  for (int i = 0; i <= tick; ++i) {
    if (i > 0) simulation->Tick();
    const world::OverlaySnapshot overlays = simulation->Overlays({});
    std::vector<Vec3> places;
    for (const auto& place : overlays.places)
      if (place.kind != world::PlaceSnapshot::Kind::kThing) places.push_back(place.position);
    watcher.Show(simulation->Snapshot(), overlays);
    scenery = SceneryAround(simulation->Snapshot(), places);
  }
  const Projection view(watcher.camera().pose(), 1280, 720);
  int seen = 0;
  for (const FramedBody& body : scenery) {
    const auto at = view.Project(body.position);
    seen += at && at->x > 0 && at->x < 1280 && at->y > 0 && at->y < 720 ? 1 : 0;
  }
  return {seen, static_cast<int>(scenery.size())};
}

TEST(CameraKeeper, ShowsTheWallsAndFiguresThatStandAroundTheAgents) {
  // Two walls with two wings each; 32 soldiers, most of them with a rifle.
  EXPECT_EQ(SceneryIn("soar_reward", 30), (std::pair{24, 24}));
  const auto [seen, all] = SceneryIn("animation", 30);
  EXPECT_EQ(seen, all);
  EXPECT_GT(all, 32);
  // The eight covers of a fight, from its first second to its end.
  for (const int tick : {30, 300, 900, 1800})
    EXPECT_EQ(SceneryIn("soar_skirmish", tick), (std::pair{32, 32})) << "at " << tick / 30 << " s";
}

TEST(CameraKeeper, RestsWhileNobodyIsAboutToLeaveThePicture) {
  Watcher watcher(1280, 720);
  world::SceneSnapshot scene;
  scene.camera.position = {0, 12, 20};
  scene.agents = {AgentAt(1, {-6, 0.9f, 0}), AgentAt(2, {6, 0.9f, 0})};
  watcher.Show(scene, {});
  const Vec3 before = watcher.camera().pose().position;
  for (int i = 0; i < 300; ++i) {
    // It walks back and forth, well within the picture.
    scene.agents[0].position.x = -6 + 0.5f * std::sin(0.1f * static_cast<float>(i));
    watcher.Show(scene, {});
  }
  EXPECT_EQ(watcher.camera().pose().position, before);
}

TEST(CameraKeeper, GoesAlongWithARunnerAndComesNearAgainOnceAllAreTogether) {
  Watcher watcher(1280, 720);
  world::SceneSnapshot scene;
  scene.camera.position = {0, 12, 20};
  scene.agents = {AgentAt(1, {0, 0.9f, 0}), AgentAt(2, {1, 0.9f, 0})};
  watcher.Show(scene, {});
  const float near_m = world::Distance(watcher.camera().pose().position, {0, 0, 0});
  float smallest_px = 0;
  for (int i = 0; i < 240; ++i) {
    scene.agents[0].velocity = {5, 0, 0};
    scene.agents[0].position.x += 5 * kFrame_s;
    watcher.Show(scene, {});
    EXPECT_EQ(watcher.Missing(scene, smallest_px), "") << "after " << i << " frames";
  }
  EXPECT_GT(world::Distance(watcher.camera().pose().position, scene.agents[0].position), 2 * near_m);
  scene.agents[1].position.x = scene.agents[0].position.x + 1;
  scene.agents[0].velocity = {};
  for (int i = 0; i < 300; ++i) watcher.Show(scene, {});
  EXPECT_LT(world::Distance(watcher.camera().pose().position, scene.agents[0].position), 1.3f * near_m);
}

TEST(CameraKeeper, StandsStillOverTheGroundOnWhichAFastWorldRunsAbout) {
  CameraRig camera;
  world::CameraSnapshot begin;
  begin.position = {0, 12, 20};
  camera.MoveTo(begin);
  camera.BeginKeeping();
  RecentGround ground;
  Vec3 settled;
  for (int frame = 0; frame < 300; ++frame) {
    // Once round in six frames: 5 m/s, sixty times as fast as real time.
    const auto angle = static_cast<float>(frame);
    world::SceneSnapshot scene;
    scene.agents = {AgentAt(1, {10 * std::cos(angle), 0.9f, 10 * std::sin(angle)})};
    std::vector<FramedBody> bodies{BodyAt(scene.agents[0].position)};
    ground.Note(bodies, kFrame_s);
    ground.AddTo(bodies);
    camera.Keep(bodies, {}, 16.0f / 9, kFrame_s);
    camera.Update({}, kFrame_s, nullptr, 720);
    if (frame == 150) settled = camera.pose().position;
    if (frame <= 150) continue;
    EXPECT_LT(world::Distance(camera.pose().position, settled), 0.5f) << "after " << frame << " frames";
    const auto feet = Projection(camera.pose(), 1280, 720).Project(scene.agents[0].position);
    ASSERT_TRUE(feet.has_value());
    EXPECT_TRUE(feet->x > 0 && feet->x < 1280 && feet->y > 0 && feet->y < 720) << "after " << frame << " frames";
  }
  EXPECT_LT(world::Length(settled), 60) << "the picture is no wider than the ground";
}

TEST(CameraKeeper, IsTheUsersOnceItIsSteeredAndComesBackWhenAsked) {
  Watcher watcher(1280, 720);
  world::SceneSnapshot scene;
  scene.camera.position = {0, 12, 20};
  scene.agents = {AgentAt(1, {0, 0.9f, 0})};
  watcher.Show(scene, {});
  CameraRig& camera = watcher.camera();
  ASSERT_TRUE(camera.keeps());
  for (const CameraInput& input :
       {CameraInput{.wheel = 1}, CameraInput{.forward = 1}, CameraInput{.looking = true, .mouse_dx = 5},
        CameraInput{.panning = true, .mouse_dy = 5}}) {
    camera.BeginKeeping();
    camera.Update(input, kFrame_s, nullptr, 720);
    EXPECT_FALSE(camera.keeps());
  }
  // A held button alone moves nothing.
  camera.BeginKeeping();
  camera.Update({.looking = true}, kFrame_s, nullptr, 720);
  EXPECT_TRUE(camera.keeps());
  camera.MoveTo(scene.camera);
  EXPECT_FALSE(camera.keeps()) << "a script has the camera";
  camera.SetMode(CameraMode::kFollow, &scene.agents[0]);
  camera.BeginKeeping();
  EXPECT_FALSE(camera.keeps()) << "it follows one agent";
}

TEST(CameraKeeper, TakesPlacesInAsLongAsAgentsStayLarge) {
  const std::vector<FramedBody> agents{BodyAt({0, 0.9f, 0})};
  const std::vector<Vec3> places{{0, 0, -12}, {10, 0, 0}, {0, 0, 400}};
  const world::Quat down{0.9f, -0.43f, 0, 0};
  const auto all = WithPlaces(agents, places, world::Normalized(down), 45, 1.6f);
  EXPECT_EQ(all.size(), 3U) << "the agent and the two places near it";
}

TEST(CameraKeeper, LeavesStragglersOutWhenAllTogetherWouldBeSpecks) {
  std::vector<FramedBody> agents;
  for (int i = 0; i < 20; ++i) agents.push_back(BodyAt({static_cast<float>(i), 0.9f, 0}));
  agents.push_back(BodyAt({9000, 0.9f, 0}));
  CameraKeeper keeper;
  world::CameraSnapshot goal;
  goal.orientation = world::Normalized({0.9f, -0.43f, 0, 0});
  goal.position = {0, 500, 5000};
  const auto asked = keeper.Follow(agents, {}, goal, 1.6f, kFrame_s);
  ASSERT_TRUE(asked.has_value());
  EXPECT_LT(world::Distance(asked->position, agents[10].position), 40);
}

}  // namespace
}  // namespace soarbox::viewer
