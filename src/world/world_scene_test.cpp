// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "world/rotation.h"
#include "world/world.h"

namespace soarbox::world {
namespace {

void ExpectNear(Vec3 actual, Vec3 expected, float tolerance = 1e-4f) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

TEST(WorldScene, AgentsAndObjectsShareOneCounterThatStartsAtOne) {
  World world;
  EXPECT_EQ(Number(world.CreatePlane(200, 200)), 1u);
  EXPECT_EQ(Number(world.CreateAgent({})), 2u);
  EXPECT_EQ(Number(world.CreateBox(1, 1, 1)), 3u);
  EXPECT_EQ(world.FindAgent(EntityId{3}), nullptr);
  EXPECT_EQ(world.FindObject(EntityId{2}), nullptr);
}

TEST(WorldScene, NodesLagTheirBodiesUntilTheyAreSynced) {
  World world;
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  const NodeId hat = world.scene().CreateBox(agent.node(), 1, 1, 1);
  world.scene().SetPosition(hat, {0, 1, 0.5f});
  agent.SetPosition({10, 5, 0});
  agent.SetForward({1, 0, 0});
  ExpectNear(world.scene().WorldPosition(hat), {10.5f, 6, 0});
  world.BeginTick();
  world.Step();
  EXPECT_LT(agent.Position().y, 5);
  ExpectNear(world.scene().WorldPosition(hat), {10.5f, 6, 0});
  world.SyncAgent(agent.id());
  EXPECT_LT(world.scene().WorldPosition(hat).y, 6);
}

TEST(WorldScene, ASnapshotShowsShapesCentredInWorldSpace) {
  World world;
  const NodeId cylinder = world.scene().CreateCylinder(NodeId::kRoot, 4, 0.5f);
  world.scene().SetPosition(cylinder, {1, 0, 0});
  const NodeId line = world.scene().CreateLine(NodeId::kRoot, {0, 0, 0}, {0, 0, 2});
  world.scene().SetMaterial(line, "Red");
  Agent& agent = *world.FindAgent(world.CreateAgent({.name = "scout", .kind = "lua", .script = "", .defaults = {}}));
  world.scene().CreateCapsule(agent.node(), 1.6f, 0.3f);

  const SceneSnapshot snapshot = world.Snapshot();
  ASSERT_EQ(snapshot.drawables.size(), 3u);
  ExpectNear(snapshot.drawables[0].position, {1, 2, 0});
  ExpectNear(snapshot.drawables[1].position, {0, 0, 1});
  ExpectNear(Rotate(snapshot.drawables[1].orientation, {0, 1, 0}), {0, 0, 1});
  EXPECT_EQ(snapshot.drawables[1].material, "Red");
  EXPECT_TRUE(snapshot.drawables[2].belongs_to_agent);
  EXPECT_EQ(snapshot.drawables[2].owner_id, Number(agent.id()));
  ASSERT_EQ(snapshot.agents.size(), 1u);
  EXPECT_EQ(snapshot.agents[0].name, "scout");
}

TEST(WorldScene, RemovingANodeRemovesWhatHangsBelowIt) {
  World world;
  Scene& scene = world.scene();
  const NodeId top = scene.CreateBox(NodeId::kRoot, 1, 1, 1);
  const NodeId below = scene.CreateBox(top, 1, 1, 1);
  const EntityId object = world.CreateBox(1, 1, 1);
  EXPECT_FALSE(scene.Remove(world.NodeOf(object)));
  EXPECT_FALSE(scene.Remove(NodeId::kRoot));
  EXPECT_TRUE(scene.Remove(top));
  EXPECT_FALSE(scene.Contains(below));
  EXPECT_FALSE(scene.Remove(top));
  EXPECT_EQ(scene.CreateBox(top, 1, 1, 1), NodeId::kNone);
  EXPECT_FALSE(scene.SetPosition(below, {}));
}

TEST(WorldScene, VisibilityCascadesAndLightsFollowTheirNode) {
  World world;
  Scene& scene = world.scene();
  const NodeId top = scene.CreateBox(NodeId::kRoot, 1, 1, 1);
  const NodeId below = scene.CreateBox(top, 1, 1, 1);
  scene.SetVisible(top, false);
  EXPECT_FALSE(scene.IsVisible(below));
  scene.SetVisible(below, true);
  EXPECT_TRUE(scene.IsVisible(below));

  const NodeId light = scene.CreatePointLight(NodeId::kRoot, {1, 2, 3});
  EXPECT_TRUE(scene.SetLightDiffuse(light, {1.8f, 1.4f, 0.9f}));
  EXPECT_FALSE(scene.SetLightDiffuse(top, {1, 1, 1}));
  const SceneSnapshot snapshot = world.Snapshot();
  ASSERT_EQ(snapshot.lights.size(), 1u);
  ExpectNear(snapshot.lights[0].position, {1, 2, 3});
  EXPECT_FLOAT_EQ(snapshot.lights[0].attenuation[1], 0.15f);
}

TEST(WorldScene, UnknownMediaGetAStandInAndOneWarningPerName) {
  World world;
  const EntityId crate = world.CreateObject("models/crate.mesh");
  world.CreateObject("models/crate.mesh");
  const NodeId mesh = world.scene().CreateMesh(NodeId::kRoot, "models/nobiax_modular/modular_blok.mesh");
  world.scene().SetMaterial(mesh, "Grund2");
  world.scene().SetSky("NoSuchSky", {});
  world.scene().CreateParticle(NodeId::kRoot, "Smoke");

  const auto warnings = world.TakeWarnings();
  ASSERT_EQ(warnings.size(), 5u);
  EXPECT_EQ(warnings[0].severity, Severity::kWarning);
  EXPECT_EQ(warnings[0].message, "unknown mesh \"models/crate.mesh\"");
  EXPECT_THAT(warnings[1].hint, ::testing::HasSubstr("modular_block.mesh"));
  EXPECT_THAT(warnings[2].hint, ::testing::HasSubstr("Ground2"));
  EXPECT_TRUE(world.TakeWarnings().empty());

  EXPECT_NEAR(world.FindObject(crate)->Radius(), std::sqrt(3.0f) / 2, 0.05f);
  const SceneSnapshot snapshot = world.Snapshot();
  EXPECT_EQ(snapshot.drawables[0].shape, ShapeKind::kBox);
  EXPECT_EQ(snapshot.drawables[0].size, (Vec3{1, 1, 1}));
  EXPECT_EQ(snapshot.drawables[2].material, "White");
}

TEST(WorldScene, NodesHangSoManyBelowEachOtherAtMost) {
  World world;
  Scene& scene = world.scene();
  NodeId deepest = NodeId::kRoot, next = NodeId::kRoot;
  for (int i = 0; next != NodeId::kNone && i < 1000; ++i) {
    deepest = next;
    next = scene.CreateBox(deepest, 1, 1, 1);
  }
  EXPECT_EQ(scene.Depth(deepest), Scene::kDeepest);
  const NodeId mesh = scene.CreateMesh(NodeId::kRoot, "models/soarbox/soldier.mesh");
  const NodeId chain = scene.CreateBox(NodeId::kRoot, 1, 1, 1);
  NodeId end = chain;
  for (int i = 1; i < Scene::kDeepest - 1; ++i) end = scene.CreateBox(end, 1, 1, 1);
  EXPECT_TRUE(scene.AttachToBone(mesh, 0, chain, {}, {}));
  EXPECT_EQ(scene.Depth(end), Scene::kDeepest);
  const NodeId carrier = scene.CreateMesh(NodeId::kRoot, "models/soarbox/soldier.mesh");
  EXPECT_FALSE(scene.AttachToBone(carrier, 0, mesh, {}, {}));
}

TEST(WorldScene, DebugLinesLastOneTick) {
  World world;
  world.debug().Circle({0, 0, 0}, 1, {1, 0, 0});
  world.debug().Circle({0, 0, 0}, 0, {1, 0, 0});
  const auto lines = [&world] {
    const SceneSnapshot snapshot = world.Snapshot();
    std::vector<LineSnapshot> all = snapshot.lines;
    AppendLines(snapshot.circles, all);
    return all;
  };
  EXPECT_EQ(lines().size(), 10u);
  EXPECT_EQ(lines().size(), world.debug().size());
  world.debug().Sphere({0, 0, 0}, 1, {1, 0, 0}, true);
  EXPECT_EQ(lines().size(), 130u);
  EXPECT_EQ(world.Snapshot().triangles.size(), 80u);
  world.debug().Line({std::numeric_limits<float>::infinity(), 0, 0}, {}, {1, 1, 1});
  EXPECT_EQ(lines().size(), 130u);
  world.BeginTick();
  EXPECT_TRUE(lines().empty());
}

TEST(WorldScene, PhysicsIsDrawnOnlyWhenSwitchedOn) {
  World world;
  world.CreatePlane(200, 200);
  world.CreateAgent({});
  world.BeginTick();
  world.Step();
  EXPECT_TRUE(world.Snapshot().lines.empty());
  world.SetDrawPhysics(true);
  world.BeginTick();
  world.Step();
  EXPECT_GT(world.Snapshot().lines.size(), 12u);
}

TEST(WorldScene, TheCameraKnowsTheSandboxesRotations) {
  World world;
  Camera& camera = world.camera();
  camera.SetRotationVector({-160, 0, -180});
  EXPECT_GT(camera.Forward().z, 0.9f) << "towards +z";
  EXPECT_NEAR(camera.Forward().y, -0.342f, 0.001f) << "20 degrees down";
  ExpectNear(FromRotationVector(camera.RotationVector()).w * Vec3{1, 1, 1}, camera.Orientation().w * Vec3{1, 1, 1});
  camera.SetBackward({0, 0, -1});
  ExpectNear(camera.Forward(), {0, 0, 1});
  ExpectNear(camera.Up(), {0, 1, 0});
  EXPECT_EQ(camera.moves(), 2u);
  camera.FollowViewer({1, 2, 3}, {});
  EXPECT_EQ(camera.moves(), 2u);
  EXPECT_EQ(camera.Position(), (Vec3{1, 2, 3}));
}

TEST(WorldScene, RotationVectorsSurviveTheRoundTrip) {
  for (const Vec3 degrees : {Vec3{10, 20, 30}, Vec3{-131, -68, -133}, Vec3{0, 90, 0}, Vec3{40, 0, -170}}) {
    const Quat rotation = FromRotationVector(degrees);
    const Quat again = FromRotationVector(ToRotationVector(rotation));
    ExpectNear(Rotate(again, {1, 2, 3}), Rotate(rotation, {1, 2, 3}), 1e-3f);
  }
  ExpectNear(Rotate(ShortestArc({0, 0, 2}, {3, 0, 0}), {0, 0, 1}), {1, 0, 0});
  ExpectNear(Rotate(ShortestArc({1, 0, 0}, {-5, 0, 0}), {1, 0, 0}), {-1, 0, 0});
  EXPECT_EQ(ToRotationVector(ShortestArc({1, 1, 0}, {1, 1, 0})), (Vec3{0, 0, 0}));
}

TEST(WorldScene, ComponentsOfTheUserInterfaceFollowTheirParent) {
  World world;
  Ui& ui = world.ui();
  const UiId panel = ui.Create(1);
  const UiId child = ui.CreateChild(panel);
  ui.Edit(panel)->view.x = 100;
  ui.Edit(panel)->view.y = 50;
  ui.Edit(child)->view.x = 5;
  EXPECT_EQ(ui.ScreenPosition(child).x, 105);
  EXPECT_EQ(ui.OffsetPosition(child).y, 50);
  EXPECT_EQ(ui.Create(16), UiId::kNone);
  EXPECT_EQ(ui.Edit(UiId{99}), nullptr);
  ui.Edit(panel)->markup = "%1hello";
  const SceneSnapshot snapshot = world.Snapshot();
  ASSERT_EQ(snapshot.ui.size(), 2u);
  EXPECT_TRUE(snapshot.ui[0].is_markup);
  EXPECT_EQ(snapshot.ui[0].text, "%1hello");
  EXPECT_EQ(snapshot.ui[1].parent_id, Number(panel));
  EXPECT_EQ(Ui::FontByName("medium_mono"), UiFont::kMediumMono);
  EXPECT_FALSE(Ui::FontByName("gothic").has_value());
}

TEST(WorldScene, PathsAreMeasuredAlongTheirPoints) {
  World world;
  Agent& agent = *world.FindAgent(world.CreateAgent({}));
  EXPECT_FALSE(agent.PointOnPath(1).has_value());
  const std::vector<Vec3> points{{0, 0, 0}, {30, 0, 0}, {30, 0, 0}, {30, 0, 50}, {-30, 0, 0}, {-30, 0, 20}};
  agent.SetPath(points, true);
  EXPECT_EQ(agent.PathPoints().size(), 7u);
  EXPECT_FLOAT_EQ(*agent.DistanceAlongPath({31, 0, 10}), 40);
  ExpectNear(*agent.NearestPointOnPath({31, 0, 10}), {30, 0, 10});
  ExpectNear(*agent.PointOnPath(-1), *agent.PointOnPath(214.158f - 1), 0.01f);
  agent.SetPath(points, false);
  ExpectNear(*agent.PointOnPath(-1), {0, 0, 0});
  ExpectNear(*agent.PointOnPath(1e6f), {-30, 0, 20});
  agent.SetPath({}, true);
  EXPECT_TRUE(agent.HasPath());
  EXPECT_FALSE(agent.NearestPointOnPath({}).has_value());
}

}  // namespace
}  // namespace soarbox::world
