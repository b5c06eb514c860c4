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

DemoScene::DemoScene(int agents, int view, int width_px, int height_px)
    : agents_(agents), view_(view), width_(width_px), height_(height_px) {}

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
  if (view_ != 1 && view_ != 3) return;
  AddMesh(scene, "modular_wall_brick_1", {0, 1.28f, 12}, 0);
  AddMesh(scene, "modular_brick_window_1", {2.56f, 1.28f, 12}, 0);
  AddMesh(scene, "modular_brick_door", {5.12f, 0.77f, 12}, 0);
  AddMesh(scene, "modular_concrete_double_window", {7.68f, 1.28f, 12}, 0);
  AddMesh(scene, "modular_wall_concrete_1", {10.24f, 1.28f, 12}, 0);
  AddMesh(scene, "modular_pillar_brick_1", {-2.0f, 1.28f, 12}, 0);
  AddMesh(scene, "modular_pillar_concrete_1", {12.4f, 1.28f, 12}, 0);
  AddMesh(scene, "modular_hangar_door", {14.6f, 1.28f, 12}, 0);
  AddMesh(scene, "no_such_thing", {-4.5f, 0.5f, 11}, 0.4f);
  DrawableSnapshot box = Thing(scene, ShapeKind::kBox, {0, 0.5f, 7}, {1, 1, 1});
  box.material = "Red";
  scene.drawables.push_back(box);
  DrawableSnapshot ball = Thing(scene, ShapeKind::kSphere, {2.5f, 0.6f, 7}, {0.6f, 0, 0});
  ball.material = "Blue";
  scene.drawables.push_back(ball);
  DrawableSnapshot drum = Thing(scene, ShapeKind::kCylinder, {5, 0.6f, 7}, {0.45f, 1.2f, 0});
  drum.material = "Green";
  scene.drawables.push_back(drum);
  DrawableSnapshot pill = Thing(scene, ShapeKind::kCapsule, {7, 0.8f, 7}, {0.3f, 1.6f, 0});
  scene.drawables.push_back(pill);
  DrawableSnapshot glass = Thing(scene, ShapeKind::kBox, {9, 0.8f, 7}, {1.2f, 1.6f, 0.2f});
  glass.material = "TransparentBlue";
  scene.drawables.push_back(glass);
  for (int i = 0; i < 24; ++i) {
    const float a = 2 * kPi * static_cast<float>(i) / 24, b = 2 * kPi * static_cast<float>(i + 1) / 24;
    scene.triangles.push_back({{-3, 0.03f, 6},
                               {-3 + 1.5f * std::sin(a), 0.03f, 6 + 1.5f * std::cos(a)},
                               {-3 + 1.5f * std::sin(b), 0.03f, 6 + 1.5f * std::cos(b)},
                               {0.2f, 1, 1, 0.4f}});
  }
  world::ParticleSnapshot burst;
  burst.id = 900001;
  burst.effect = "BulletImpact";
  burst.position = {-3, 1, 6};
  burst.has_direction = true;
  burst.direction = {0, 1, 0};
  scene.particles.push_back(burst);
  world::UiSnapshot sign;
  sign.id = 2;
  sign.in_world = true;
  sign.world_position = {4.0f, 3.6f, 11.7f};
  sign.world_orientation = Yaw(kPi);
  sign.width = 400;
  sign.height = 70;
  sign.margin_left = sign.margin_top = 14;
  sign.has_gradient = true;
  sign.gradient_from = {0.05f, 0.15f, 0.3f, 0.9f};
  sign.gradient_to = {0.1f, 0.3f, 0.5f, 0.9f};
  sign.is_markup = true;
  sign.text = "%@24%A sign in the %4world";
  scene.ui.push_back(sign);
  DrawableSnapshot crate = Thing(scene, ShapeKind::kBox, {11.5f, 0.6f, 7}, {1.2f, 1.2f, 1.2f});
  crate.material = "NobiaxModular";
  scene.drawables.push_back(crate);
}

void DemoScene::AddAgents(SceneSnapshot& scene, double time_s) const {
  const auto t = static_cast<float>(time_s);
  constexpr const char* kKinds[] = {"soar seeking",  "soar follower", "soar follower",
                                    "soar follower", "soar waypoint", "lua"};
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(agents_))));
  for (int i = 0; i < agents_; ++i) {
    const int kind = agents_ <= 6 ? i : i % 6;
    const float phase = 1.3f * static_cast<float>(i), turn = 0.35f * t + phase;
    Vec3 home{-20.0f + 4.4f * static_cast<float>(i % 3), 0, 2.5f + 5.4f * static_cast<float>(i / 3)};
    if (agents_ > 6)
      home = {2.2f * static_cast<float>(i % columns - columns / 2), 0,
              2.2f * static_cast<float>(i / columns - columns / 2)};
    const float radius = agents_ > 6 ? 0.5f : 1.6f;
    world::AgentSnapshot agent;
    agent.id = static_cast<std::uint32_t>(i + 1);
    agent.kind = kKinds[kind];
    agent.name = (i == 0      ? "seeker-"
                  : kind == 4 ? "waypoint-"
                  : kind == 5 ? "leader-"
                              : "follower-") +
                 std::to_string(i + 1);
    agent.script = kind == 4 ? "WaypointsAgent.lua" : kind == 0 ? "SeekingAgent.lua" : "FollowerAgent.lua";
    agent.last_command = kind == 5 ? "" : kind == 0 ? "sametarget" : kind == 4 ? "samewaypoint" : "follow";
    agent.radius_m = 0.3f;
    agent.height_m = 1.6f;
    agent.position = home + Vec3{radius * std::cos(turn), 0.8f, radius * std::sin(turn)};
    agent.forward = {-std::sin(turn), 0, std::cos(turn)};
    agent.velocity = agent.forward * (0.35f * radius);
    agent.health = i == 2 ? 60.0f : 100.0f;
    scene.agents.push_back(agent);

    DrawableSnapshot body = Thing(scene, ShapeKind::kCapsule, agent.position, {0.3f, 1.6f, 0});
    body.id = agent.id;
    body.owner_id = agent.id;
    body.belongs_to_agent = true;
    body.material = "Ground2";
    body.orientation = Yaw(std::atan2(agent.forward.x, agent.forward.z));
    scene.drawables.push_back(body);
    if (agents_ > 100) continue;
    const Vec3 foot = agent.position - Vec3{0, 0.75f, 0};
    AddCircle(scene, foot, 1.0f,
              kind == 0   ? Color{1, 0, 0, 1}
              : kind == 4 ? Color{0, 1, 0, 1}
                          : Color{1, 0.65f, 0, 1},
              10);
    scene.lines.push_back({agent.position, agent.position + agent.forward * 1.2f, {1, 1, 1, 1}});
    if (kind == 0) {
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
  struct View {
    Vec3 from, to;
  };
  constexpr View kViews[] = {{{-30, 5, 7}, {-14, 1.0f, 9.5f}},
                             {{4, 4.2f, -4}, {5, 1.2f, 8}},
                             {{-22.5f, 1.9f, 3.2f}, {-17, 0.9f, 6}},
                             {{-40, 30, -40}, {0, 0, 0}}};
  const View& view = kViews[static_cast<std::size_t>(view_) % std::size(kViews)];
  scene.camera.position = view.from;
  scene.camera.orientation = LookAt(view.from, view.to);
  scene.camera_moves = 1;
}

}  // namespace soarbox::viewer
