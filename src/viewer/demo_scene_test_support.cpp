// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/demo_scene_test_support.h"

#include <cmath>

#include "viewer/half_turn.h"

namespace soarbox::viewer {
namespace {

using world::Color;
using world::DrawableSnapshot;
using world::Quat;
using world::SceneSnapshot;
using world::ShapeKind;
using world::Vec3;

Quat Yaw(float angle) {
  return {std::cos(angle / 2), 0, std::sin(angle / 2), 0};
}

Quat LookAt(Vec3 from, Vec3 to) {
  const Vec3 d = world::Normalized(to - from);
  const float yaw = std::atan2(-d.x, -d.z), pitch = std::asin(d.y);
  return Yaw(yaw) * Quat{std::cos(pitch / 2), std::sin(pitch / 2), 0, 0};
}

void AddCircle(SceneSnapshot& scene, Vec3 centre, float radius, Color color, int pieces) {
  const auto point = [&](int i) {
    const float angle = 2 * kPi * static_cast<float>(i) / static_cast<float>(pieces);
    return centre + Vec3{radius * std::cos(angle), 0, radius * std::sin(angle)};
  };
  for (int i = 0; i < pieces; ++i) scene.lines.push_back({point(i), point(i + 1), color});
}

DrawableSnapshot Thing(SceneSnapshot& scene, ShapeKind shape, Vec3 position, Vec3 size) {
  DrawableSnapshot thing;
  thing.id = static_cast<std::uint32_t>(100000 + scene.drawables.size());
  thing.owner_id = thing.id;
  thing.shape = shape;
  thing.position = position;
  thing.size = size;
  return thing;
}

void AddMesh(SceneSnapshot& scene, const char* name, Vec3 position, float yaw) {
  DrawableSnapshot thing = Thing(scene, ShapeKind::kMesh, position, {});
  thing.mesh = std::string("models/nobiax_modular/") + name + ".mesh";
  thing.orientation = Yaw(yaw);
  scene.drawables.push_back(thing);
}

}  // namespace

DemoScene::DemoScene(int agents, int width_px, int height_px) : agents_(agents), width_(width_px), height_(height_px) {}

SceneSnapshot DemoScene::At(double time_s) const {
  SceneSnapshot scene;
  scene.tick = static_cast<std::uint64_t>(time_s * 30);
  scene.time_s = time_s;
  scene.sky = "ThickCloudsWaterSkyBox";
  scene.sky_rotation_deg = {0, 180, 0};
  scene.ambient = {0.3f, 0.3f, 0.3f};
  world::LightSnapshot sun;
  sun.direction = {1, -1, 1};
  sun.diffuse = {1.8f, 1.4f, 0.9f};
  scene.lights.push_back(sun);
  scene.markup_palette = {Color{1, 1, 1, 1}, {1, 0, 0, 1}, {0, 1, 0, 1},    {0, 0, 1, 1},          {1, 1, 0, 1},
                          {1, 0, 1, 1},      {0, 1, 1, 1}, {1, .65f, 0, 1}, {.75f, .75f, .75f, 1}, {0, 0, 0, 1}};
  AddGround(scene);
  AddBlocks(scene);
  AddAgents(scene, time_s);
  AddText(scene);
  PlaceCamera(scene);
  return scene;
}

void DemoScene::AddGround(SceneSnapshot& scene) const {
  DrawableSnapshot ground = Thing(scene, ShapeKind::kPlane, {}, {200, 0, 200});
  ground.material = "Ground2";
  ground.texture_repeats = {100, 100, 1};
  scene.drawables.push_back(ground);
}

void DemoScene::AddBlocks(SceneSnapshot& scene) const {
  for (int i = 0; i < 5; ++i)
    AddMesh(scene, "modular_block", {-12.0f + 0.85f * static_cast<float>(i), 0.32f, 14}, 0.05f * static_cast<float>(i));
  for (int i = 0; i < 3; ++i)
    AddMesh(scene, "modular_block", {-11.5f + 0.85f * static_cast<float>(i), 0.96f, 14}, 0.3f);
}

void DemoScene::AddAgents(SceneSnapshot& scene, double time_s) const {
  const auto t = static_cast<float>(time_s);
  constexpr const char* kKinds[] = {"soar seeking",  "soar follower", "soar follower",
                                    "soar follower", "soar waypoint", "lua"};
  for (int i = 0; i < agents_; ++i) {
    const float phase = 1.3f * static_cast<float>(i), turn = 0.35f * t + phase;
    const Vec3 home{-20.0f + 4.4f * static_cast<float>(i % 3), 0, 2.5f + 5.4f * static_cast<float>(i / 3)};
    constexpr float kRadius_m = 1.6f;
    world::AgentSnapshot agent;
    agent.id = static_cast<std::uint32_t>(i + 1);
    agent.kind = kKinds[i];
    agent.name = (i == 0 ? "seeker-" : i == 4 ? "waypoint-" : i == 5 ? "leader-" : "follower-") + std::to_string(i + 1);
    agent.script = i == 4 ? "WaypointsAgent.lua" : i == 0 ? "SeekingAgent.lua" : "FollowerAgent.lua";
    agent.last_command = i == 5 ? "" : i == 0 ? "sametarget" : i == 4 ? "samewaypoint" : "follow";
    agent.radius_m = 0.3f;
    agent.height_m = 1.6f;
    agent.position = home + Vec3{kRadius_m * std::cos(turn), 0.8f, kRadius_m * std::sin(turn)};
    agent.forward = {-std::sin(turn), 0, std::cos(turn)};
    agent.velocity = agent.forward * (0.35f * kRadius_m);
    agent.health = i == 2 ? 60.0f : 100.0f;
    scene.agents.push_back(agent);

    DrawableSnapshot body = Thing(scene, ShapeKind::kCapsule, agent.position, {0.3f, 1.6f, 0});
    body.id = agent.id;
    body.owner_id = agent.id;
    body.belongs_to_agent = true;
    body.material = "Ground2";
    body.orientation = Yaw(std::atan2(agent.forward.x, agent.forward.z));
    scene.drawables.push_back(body);
    const Vec3 foot = agent.position - Vec3{0, 0.75f, 0};
    AddCircle(scene, foot, 1.0f, i == 0 ? Color{1, 0, 0, 1} : i == 4 ? Color{0, 1, 0, 1} : Color{1, 0.65f, 0, 1}, 10);
    scene.lines.push_back({agent.position, agent.position + agent.forward * 1.2f, {1, 1, 1, 1}});
    if (i == 0) {
      const Vec3 target = home + Vec3{6, 0.05f, 5};
      scene.lines.push_back({foot, target, {1, 0, 0, 1}});
      AddCircle(scene, target, 2.5f, {1, 0, 0, 1}, 10);
    }
  }
}

void DemoScene::AddText(SceneSnapshot& scene) const {
  world::UiSnapshot box;
  box.id = 1;
  box.width = 300;
  box.height = 180;
  box.x = static_cast<float>(width_) - box.width - 20;
  box.y = static_cast<float>(height_) - box.height - 35;
  box.margin_left = box.margin_top = 10;
  box.has_gradient = true;
  box.gradient_from = {0, 0, 0, 0.75f};
  box.gradient_to = {0.1f, 0.1f, 0.1f, 0.5f};
  box.is_markup = true;
  box.text =
      "%0%@91%W/A/S/D: to move\nHold Shift: to accelerate movement\nHold RMB: to look\n\nSpace: shoot block\n\n"
      "F1: to reset the camera\nF2: toggle the menu\nF5: toggle performance information\n"
      "F6: toggle camera information\nF7: toggle physics debug";
  scene.ui.push_back(box);
}

void DemoScene::PlaceCamera(SceneSnapshot& scene) const {
  const Vec3 from{-30, 5, 7};
  scene.camera.position = from;
  scene.camera.orientation = LookAt(from, {-14, 1.0f, 9.5f});
  scene.camera_moves = 1;
}

}  // namespace soarbox::viewer
