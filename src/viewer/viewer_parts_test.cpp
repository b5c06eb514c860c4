// SPDX-License-Identifier: BSD-2-Clause
// The parts of the window that need no display: meshes, pictures, camera, picking, markup.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "viewer/backdrop_meshes.h"
#include "viewer/body_mesh.h"
#include "viewer/camera_rig.h"
#include "viewer/figure_meshes.h"
#include "viewer/images.h"
#include "viewer/interpolate.h"
#include "viewer/markup.h"
#include "viewer/modular_mesh_shapes.h"
#include "viewer/palette.h"
#include "viewer/picking.h"
#include "viewer/render_scale.h"
#include "viewer/scenery_mesh_shapes.h"
#include "viewer/script_ui_places.h"
#include "viewer/shape_meshes.h"
#include "world/body_meshes.h"
#include "world/modular_meshes.h"
#include "world/rotation.h"
#include "world/scenery_meshes.h"

namespace soarbox::viewer {
namespace {

using world::Vec3;

/// Checks that each triangle faces the direction of its vertices' normals; skips degenerate ones.
void ExpectOutwardTriangles(const MeshData& mesh) {
  ASSERT_FALSE(mesh.indices.empty());
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const MeshVertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                     &c = mesh.vertices[mesh.indices[i + 2]];
    const Vec3 facing = Cross(b.position - a.position, c.position - a.position);
    if (world::Length(facing) < 1e-7f) continue;
    ASSERT_GT(Dot(facing, a.normal + b.normal + c.normal), 0) << "triangle " << i / 3;
  }
}

TEST(ShapeMeshes, AllTrianglesFaceOutwards) {
  ExpectOutwardTriangles(BoxMesh({-1, -2, -3}, {1, 2, 3}));
  ExpectOutwardTriangles(CapsuleMesh(0.3f, 1.6f));
  ExpectOutwardTriangles(CylinderMesh(0.5f, 1));
  ExpectOutwardTriangles(SphereMesh(2));
  ExpectOutwardTriangles(PlaneMesh(10, 20, 1, 1));
}

TEST(ShapeMeshes, AgentsFillTheirCapsuleAndWearAVisorInFrontOnly) {
  for (const AgentDetail detail :
       {AgentDetail::kFine, AgentDetail::kMiddle, AgentDetail::kCoarse, AgentDetail::kTiny}) {
    const MeshData mesh = AgentMesh(0.3f, 1.6f, detail);
    const Bounds bounds = BoundsOf(mesh);
    EXPECT_NEAR(bounds.min.y, -0.8f, 0.01f);
    EXPECT_NEAR(bounds.max.y, 0.8f, 0.01f);
    EXPECT_NEAR(bounds.max.x, 0.3f, 0.03f);
    float visor_z = 0;
    int visor_vertices = 0;
    for (const MeshVertex& vertex : mesh.vertices) {
      if (vertex.gloss < 0.5f) continue;
      visor_z += vertex.position.z;
      ++visor_vertices;
    }
    ASSERT_GT(visor_vertices, 0);
    EXPECT_GT(visor_z / static_cast<float>(visor_vertices), 0.1f);
  }
}

TEST(ShapeMeshes, SizesThatMakeNoSenseGiveHarmlessMeshes) {
  for (const float size : {0.0f, -3.0f, std::nanf("")}) {
    for (const MeshData& mesh : {BoxMesh({0, 0, 0}, {size, size, size}), CapsuleMesh(size, size), AgentMesh(size, size),
                                 CylinderMesh(size, size), SphereMesh(size), PlaneMesh(size, size, 1, 1)}) {
      for (const MeshVertex& vertex : mesh.vertices) ASSERT_TRUE(IsFinite(vertex.position) && IsFinite(vertex.normal));
    }
  }
}

TEST(ModularMeshes, AllThirtyFourPiecesFillTheirBounds) {
  ASSERT_EQ(world::kModularMeshes.size(), 34u);
  for (const world::ModularMesh& piece : world::kModularMeshes) {
    const auto mesh = ModularMesh("models/nobiax_modular/" + std::string(piece.name) + ".mesh");
    ASSERT_TRUE(mesh.has_value()) << piece.name;
    ExpectOutwardTriangles(*mesh);
    const Bounds bounds = BoundsOf(*mesh);
    EXPECT_LT(world::Distance(bounds.min, piece.min), 0.001f) << piece.name;
    EXPECT_LT(world::Distance(bounds.max, piece.max), 0.001f) << piece.name;
  }
}

TEST(BodyMeshes, SoldiersAndRiflesAreWholeAtEveryDetailAndAsTallAsPeople) {
  for (const world::BodyMesh& body : world::kBodyMeshes) {
    std::size_t finer = 100'000;
    for (const BodyDetail detail : {BodyDetail::kFine, BodyDetail::kMiddle, BodyDetail::kCoarse, BodyDetail::kTiny}) {
      const SkinMesh mesh = MakeBodyMesh(body.look, detail);
      ASSERT_EQ(mesh.skin.size(), mesh.mesh.vertices.size());
      EXPECT_LT(mesh.mesh.vertices.size(), finer);
      finer = mesh.mesh.vertices.size();
      for (const MeshVertex& v : mesh.mesh.vertices) {
        ASSERT_TRUE(IsFinite(v.position) && IsFinite(v.normal)) << body.name;
        ASSERT_NEAR(world::Length(v.normal), 1, 0.01f) << body.name;
      }
      for (const SkinVertex& s : mesh.skin) {
        ASSERT_LT(s.bone, body.rig().skeleton.count());
        ASSERT_LT(s.other, body.rig().skeleton.count());
      }
      if (body.look == world::BodyLook::kRifle) continue;
      const Bounds bounds = BoundsOf(mesh.mesh);
      EXPECT_NEAR(bounds.max.y, 1.766f, 0.03f);
      EXPECT_NEAR(bounds.min.y, 0, 0.01f);
      EXPECT_LT(finer, 14'000u);
    }
  }
}

TEST(BodyMeshes, BonesInTheirBindPoseMoveABodyToItsPlaceAndNoFurther) {
  const world::Skeleton& skeleton = world::SoldierRig().skeleton;
  std::vector<world::BonePose> bones;
  for (int i = 0; i < skeleton.count(); ++i) bones.push_back(skeleton.BindInModel(i));
  SkinPlace place;
  place.at = {{3, 0, -2}, world::Turn({0, 1, 0}, 0.5f)};
  place.scale = {1, 2, 1};
  std::vector<float> rows(12 * bones.size());
  BoneRows(ToBind(skeleton), bones, place, rows.data());
  const Vec3 vertex{0.2f, 1.5f, 0.1f};
  const Vec3 wanted = place.at.position + Rotate(place.at.orientation, {0.2f, 3.0f, 0.1f});
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    const auto along = [&](std::size_t row) {
      const float* r = &rows[12 * bone + 4 * row];
      return r[0] * vertex.x + r[1] * vertex.y + r[2] * vertex.z + r[3];
    };
    ASSERT_LT(world::Distance({along(0), along(1), along(2)}, wanted), 1e-4f) << skeleton.bones()[bone].name;
  }
}

TEST(SceneryMeshes, StandOnTheGroundAndKeepTheirSize) {
  for (const world::SceneryMesh& piece : world::kSceneryMeshes) {
    const auto mesh = SceneryMeshFor(piece.name);
    ASSERT_TRUE(mesh.has_value()) << piece.name;
    for (const MeshVertex& v : mesh->vertices) ASSERT_TRUE(IsFinite(v.position) && IsFinite(v.normal)) << piece.name;
    const Bounds bounds = BoundsOf(*mesh);
    EXPECT_GT(bounds.min.y, -0.1f) << piece.name;
    EXPECT_NEAR(bounds.max.y, piece.bounds.max.y, 0.2f * piece.bounds.max.y) << piece.name;
  }
  EXPECT_FALSE(SceneryMeshFor("models/soarbox/palm.mesh").has_value());
}

TEST(ModularMeshes, UnknownNamesAreNotFound) {
  EXPECT_FALSE(ModularMesh("models/nobiax_modular/modular_castle.mesh").has_value());
  EXPECT_FALSE(ModularMesh("modular_block.mesh").has_value());
  EXPECT_FALSE(ModularMesh("").has_value());
}

TEST(Palette, NamesThatScriptsUseHaveALook) {
  Look look;
  for (const char* name : {"White", "Red", "Ground2", "NobiaxModular", "TransparentYellow", "SF_Soldier_Body"}) {
    EXPECT_TRUE(FindLook(name, look)) << name;
  }
  EXPECT_FALSE(FindLook("Mahogany", look));
}

TEST(Palette, KindsOfAgentsDifferInColour) {
  const std::vector<std::string> kinds{"lua", "soar seeking", "soar follower", "soar waypoint", "soar"};
  for (const auto& a : kinds) {
    for (const auto& b : kinds) EXPECT_EQ(a == b, AgentColor(a) == AgentColor(b)) << a << ", " << b;
  }
}

/// Draws for `seconds` with an AutoScale. A frame takes `full_s` at scale 1; a part of it does not depend on the scale.
double ScaleAfter(AutoScale& scale, double seconds, double full_s, double ticks_s = 0, int* changes = nullptr) {
  double last = scale.scale();
  for (double time_s = 0; time_s < seconds;) {
    const double drawing_s = full_s * (0.2 + 0.8 * scale.scale() * scale.scale());
    scale.Note(drawing_s, drawing_s + ticks_s);
    time_s += drawing_s + ticks_s;
    if (changes != nullptr && scale.scale() != last) ++*changes;
    last = scale.scale();
  }
  return scale.scale();
}

TEST(AutoScale, DrawsInFullWhereThereIsTime) {
  AutoScale scale;
  EXPECT_LT(scale.scale(), 1) << "slow machines begin smoothly";
  EXPECT_EQ(ScaleAfter(scale, 10, 0.010), 1);
}

TEST(AutoScale, DrawsSmallerWhereFramesAreSlowAndStaysThere) {
  AutoScale scale;
  EXPECT_EQ(ScaleAfter(scale, 10, 0.2), 0.5);
  AutoScale middle;
  const double found = ScaleAfter(middle, 20, 0.055);
  EXPECT_GT(found, 0.5);
  EXPECT_LT(found, 1);
  int changes = 0;
  ScaleAfter(middle, 600, 0.055, 0, &changes);
  EXPECT_LT(changes, 20) << "in ten minutes";
}

TEST(AutoScale, GoesUpAgainWhenTheSceneBecomesEasierButNotForATick) {
  AutoScale scale;
  ScaleAfter(scale, 10, 0.2);
  for (int i = 0; i < 4; ++i) scale.Note(0.005, 0.005);
  EXPECT_EQ(ScaleAfter(scale, 10, 0.2), 0.5);
  EXPECT_EQ(ScaleAfter(scale, 60, 0.012), 1);
}

TEST(AutoScale, DoesNotBlurThePictureForTicksThatAreSlow) {
  AutoScale scale;
  ScaleAfter(scale, 10, 0.010);
  EXPECT_EQ(ScaleAfter(scale, 10, 0.010, 0.100), 1);
}

TEST(SkyImages, CloudsAreAboveAndWaterIsBelow) {
  const auto faces = SkyImages({}, 32);
  const auto mean = [](const Image& image, std::size_t channel) {
    double sum = 0;
    for (std::size_t i = channel; i < image.pixels.size(); i += 4) sum += image.pixels[i];
    return sum / (image.width * image.height);
  };
  EXPECT_GT(mean(faces[2], 2), mean(faces[3], 2));        // Brighter above than below.
  EXPECT_GT(mean(faces[3], 2), 1.5 * mean(faces[3], 0));  // Water is blue.
  EXPECT_EQ(SkyImages({}, 32)[0].pixels, faces[0].pixels);
}

TEST(Markup, SwitchesColoursAndFontsAndCutsLines) {
  const auto lines = ParseMarkup("%0%@91%W/A/S/D: to %3move\n100%% sure");
  ASSERT_EQ(lines.size(), 2u);
  ASSERT_EQ(lines[0].size(), 2u);
  EXPECT_EQ(lines[0][0].text, "W/A/S/D: to ");
  EXPECT_EQ(lines[0][0].font, world::UiFont::kSmallMono);
  EXPECT_EQ(lines[0][1].text, "move");
  EXPECT_EQ(lines[0][1].palette_index, 3);
  EXPECT_EQ(lines[1][0].text, "100% sure");
  EXPECT_EQ(lines[1][0].palette_index, 3);
}

TEST(Markup, BadCommandsSwallowTextAsTheSandboxDoes) {
  EXPECT_EQ(ParseMarkup("a%?b").at(0).at(0).text, "ab");
  EXPECT_EQ(ParseMarkup("a%@77%b").at(0).at(0).text, "a");
  EXPECT_EQ(ParseMarkup("a%@9").at(0).at(0).text, "a");
  EXPECT_TRUE(ParseMarkup("%").at(0).empty());
  EXPECT_EQ(ParseMarkup("a%:tick%b").at(0).at(0).text, "ab");
  EXPECT_TRUE(ParseMarkup("%Mx").at(0).at(0).fixed_width);
}

world::CameraSnapshot CameraAt(Vec3 position) {
  world::CameraSnapshot camera;
  camera.position = position;
  return camera;
}

TEST(Projection, RaysAndPointsAgree) {
  const Projection view(CameraAt({1, 2, 10}), 1280, 720);
  const auto centre = view.Project({1, 2, 0});
  ASSERT_TRUE(centre.has_value());
  EXPECT_NEAR(centre->x, 640, 0.01);
  EXPECT_NEAR(centre->y, 360, 0.01);
  const Vec3 ray = view.RayThrough({200, 600});
  const auto back = view.Project(Vec3{1, 2, 10} + ray * 25);
  ASSERT_TRUE(back.has_value());
  EXPECT_NEAR(back->x, 200, 0.05);
  EXPECT_NEAR(back->y, 600, 0.05);
  EXPECT_FALSE(view.Project({1, 2, 20}).has_value());
}

TEST(Projection, AClickMeansTheNearestAgentUnderIt) {
  const Projection view(CameraAt({0, 1, 10}), 1280, 720);
  std::vector<world::AgentSnapshot> agents(3);
  const Vec3 places[] = {{0, 0.8f, 0}, {0.1f, 0.8f, 4}, {3, 0.8f, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    agents[i].id = static_cast<std::uint32_t>(7 + i);
    agents[i].position = places[i];
    agents[i].radius_m = 0.3f;
    agents[i].height_m = 1.6f;
  }
  EXPECT_EQ(view.AgentAt({640, 360}, agents), 8u);
  const auto aside = view.Project({3, 1.4f, 0});
  EXPECT_EQ(view.AgentAt(*aside, agents), 9u);
  EXPECT_EQ(view.AgentAt({20, 20}, agents), 0u);
}

TEST(FigureMesh, EachFillsItsShapeAndIsClosedEnoughToBeSeen) {
  for (const char* material : {"Soarbox/Rock", "Soarbox/Medkit", "Soarbox/Ammunition", "Soarbox/Sack", "Soarbox/Sheep",
                               "Soarbox/Bear", "Soarbox/Hare", "Soarbox/Cook"}) {
    const auto mesh = FigureMesh(material, {1.2f, 1.7f, 0.8f});
    ASSERT_TRUE(mesh.has_value()) << material;
    EXPECT_TRUE(IsFigure(material));
    EXPECT_EQ(mesh->material, material);
    EXPECT_GT(mesh->indices.size(), 300U) << material;
    const Bounds bounds = BoundsOf(*mesh);
    EXPECT_GE(bounds.min.y, -0.95f) << material;
    EXPECT_LT(bounds.max.y, 1.05f) << material;
    EXPECT_NEAR(bounds.min.y, -0.85f, 0.35f) << material << " does not stand on the ground";
    for (const MeshVertex& vertex : mesh->vertices) {
      ASSERT_TRUE(world::IsFinite(vertex.position) && world::IsFinite(vertex.normal)) << material;
      ASSERT_NEAR(world::Length(vertex.normal), 1, 0.01f) << material;
    }
  }
  EXPECT_FALSE(FigureMesh("White", {1, 1, 1}).has_value());
  EXPECT_FALSE(FigureMesh("Soarbox/Rock", {0, 1, 1}).has_value());
}

TEST(Backdrop, StandsAroundThePlainAndNotOnIt) {
  for (const MeshData& mesh : {HillsMesh(), TreesMesh(), FenceMesh()}) {
    ASSERT_FALSE(mesh.vertices.empty());
    for (const MeshVertex& vertex : mesh.vertices)
      EXPECT_GT(std::max(std::abs(vertex.position.x), std::abs(vertex.position.z)), 90) << "nobody can reach it";
    EXPECT_LT(mesh.indices.size(), 60'000U);
  }
}

TEST(CameraRig, FliesAtItsSpeedAndTwentyTimesThatWithShift) {
  for (const bool fast : {false, true}) {
    CameraRig camera;
    camera.MoveTo(CameraAt({0, 1, 0}));
    for (int i = 0; i < 120; ++i) camera.Update({.forward = 1, .fast = fast}, 1.0f / 60, nullptr, 720);
    const float gone = -camera.pose().position.z;
    EXPECT_NEAR(gone, fast ? 190 : 9.5f, fast ? 6 : 0.3f);
    for (int i = 0; i < 120; ++i) camera.Update({}, 1.0f / 60, nullptr, 720);
    const Vec3 rest = camera.pose().position;
    camera.Update({}, 1.0f / 60, nullptr, 720);
    EXPECT_EQ(camera.pose().position, rest);
  }
}

TEST(CameraRig, TheMouseTurnsItOnlyWhileTheRightButtonIsHeldAndNeverOverTheTop) {
  CameraRig camera;
  camera.MoveTo(CameraAt({0, 1, 0}));
  camera.Update({.mouse_dx = 100, .mouse_dy = 50}, 0.016f, nullptr, 720);
  EXPECT_EQ(camera.forward(), (Vec3{0, 0, -1}));
  // 600 px of 0.15 degrees: a quarter turn to the right.
  camera.Update({.looking = true, .mouse_dx = 600}, 0.016f, nullptr, 720);
  EXPECT_NEAR(camera.forward().x, 1, 1e-3);
  for (int i = 0; i < 100; ++i) camera.Update({.looking = true, .mouse_dy = -40}, 0.016f, nullptr, 720);
  EXPECT_GT(camera.forward().y, 0.98f);
  EXPECT_GT(camera.forward().x, 0);
}

world::AgentSnapshot AgentAt(std::uint32_t id, Vec3 place) {
  world::AgentSnapshot agent;
  agent.id = id;
  agent.position = place;
  return agent;
}

TEST(CameraRig, FollowsAnAgentUntilTheUserMovesIt) {
  CameraRig camera;
  camera.MoveTo(CameraAt({0, 5, 20}));
  EXPECT_FALSE(camera.SetMode(CameraMode::kFollow, nullptr)) << "there is nobody to follow";
  world::AgentSnapshot agent = AgentAt(7, {0, 1, 0});
  ASSERT_TRUE(camera.SetMode(CameraMode::kFollow, &agent));
  EXPECT_EQ(camera.agent(), 7u);
  Vec3 before = camera.pose().position;
  for (int i = 0; i < 60; ++i) {
    agent.position.x = 0.5f * static_cast<float>(i);
    camera.Update({}, 1.0f / 60, &agent, 720);
    EXPECT_LT(world::Distance(before, camera.pose().position), 2.5f) << "it jumps";
    before = camera.pose().position;
  }
  EXPECT_NEAR(world::Distance(camera.pose().position, agent.position), 12, 0.5);
  camera.Update({.left = 1}, 1.0f / 60, &agent, 720);
  EXPECT_EQ(camera.mode(), CameraMode::kFree);
  EXPECT_LT(world::Distance(before, camera.pose().position), 1.0f);
  // The eyes camera turns with the agent.
  camera.SetMode(CameraMode::kEyes, &agent);
  camera.Update({}, 1.0f / 60, nullptr, 720);
  EXPECT_EQ(camera.mode(), CameraMode::kFree);
}

TEST(CameraRig, FramesAllAgentsLargeAndWhole) {
  for (const float width : {1280.0f, 600.0f}) {
    CameraRig camera;
    camera.MoveTo(CameraAt({300, 2, 40}));
    const std::vector<world::AgentSnapshot> agents{AgentAt(1, {-20, 1, 3}), AgentAt(2, {8, 1, -6}),
                                                   AgentAt(3, {2, 1, 12})};
    const std::vector<const world::AgentSnapshot*> all{&agents[0], &agents[1], &agents[2]};
    camera.Frame(all, width / 720, true);
    camera.Arrive();
    const Projection view(camera.pose(), static_cast<int>(width), 720);
    float left = width, right = 0, top = 720, bottom = 0;
    for (const auto& agent : agents) {
      const auto at = view.Project(agent.position);
      ASSERT_TRUE(at.has_value());
      left = std::min(left, at->x), right = std::max(right, at->x);
      top = std::min(top, at->y), bottom = std::max(bottom, at->y);
    }
    EXPECT_GT(left, 10);
    EXPECT_LT(right, width - 10);
    EXPECT_GT(top, 40);
    EXPECT_LT(bottom, 700);
    EXPECT_GT((right - left) / width, 0.6f) << "they could be larger";
  }
}

TEST(CameraRig, LooksOutOfEyesAndStraightDownOnTheMap) {
  CameraRig camera;
  camera.MoveTo(CameraAt({0, 5, 20}));
  world::AgentSnapshot agent = AgentAt(3, {4, 1, 0});
  agent.forward = {1, 0, 0};
  ASSERT_TRUE(camera.SetMode(CameraMode::kEyes, &agent));
  for (int i = 0; i < 60; ++i) camera.Update({}, 1.0f / 60, &agent, 720);
  EXPECT_GT(camera.forward().x, 0.99f);
  EXPECT_NEAR(camera.pose().position.y, 1.84f, 0.1f);
  ASSERT_TRUE(camera.SetMode(CameraMode::kMap, &agent));
  for (int i = 0; i < 60; ++i) camera.Update({}, 1.0f / 60, &agent, 720);
  EXPECT_LT(camera.forward().y, -0.999f);
  const Projection view(camera.pose(), 1280, 720);
  EXPECT_LT(view.Project({4, 0, -5})->y, view.Project({4, 0, 5})->y) << "north is up";
  EXPECT_LT(view.Project({0, 0, 0})->x, view.Project({5, 0, 0})->x) << "east is to the right";
  const float before = camera.pose().position.y;
  camera.Update({.wheel = 3}, 1.0f / 60, &agent, 720);
  EXPECT_LT(camera.pose().position.y, before * 0.75f);
}

TEST(CameraRig, TheMiddleButtonDragsWhatIsUnderTheCursorAlong) {
  CameraRig camera;
  world::CameraSnapshot down = CameraAt({0, 10, 0});
  camera.MoveTo(down);
  ASSERT_TRUE(camera.SetMode(CameraMode::kMap, nullptr));
  for (int i = 0; i < 60; ++i) camera.Update({}, 1.0f / 60, nullptr, 720);
  const auto before = Projection(camera.pose(), 1280, 720).Project({0, 0, 0});
  camera.Update({.panning = true, .mouse_dx = 100, .mouse_dy = -40}, 1.0f / 60, nullptr, 720);
  const auto after = Projection(camera.pose(), 1280, 720).Project({0, 0, 0});
  ASSERT_TRUE(before && after);
  EXPECT_NEAR(after->x - before->x, 100, 1);
  EXPECT_NEAR(after->y - before->y, -40, 1);
}

TEST(CameraRig, TheWheelKeepsWhatIsUnderTheCursorWhereItIs) {
  for (const CameraMode mode : {CameraMode::kFree, CameraMode::kOrbit, CameraMode::kMap}) {
    CameraRig rig;
    world::CameraSnapshot start;
    start.position = {3, 12, 20};
    start.orientation = {std::cos(0.3f), -std::sin(0.3f), 0, 0};
    rig.MoveTo(start);
    ASSERT_TRUE(rig.SetMode(mode, nullptr));
    rig.Arrive();
    rig.Update({}, 0.016f, nullptr, 720);
    rig.Arrive();
    const ScreenPoint cursor{900, 500};
    const Vec3 way = Projection(rig.pose(), 1280, 720).RayThrough(cursor);
    const Vec3 under = rig.pose().position + way * (rig.pose().position.y / -way.y);
    CameraInput input;
    input.wheel = 2;
    input.towards = way;
    const float before = world::Distance(rig.pose().position, under);
    rig.Update(input, 0.016f, nullptr, 720);
    EXPECT_LT(world::Distance(rig.pose().position, under), 0.9f * before);
    const auto at = Projection(rig.pose(), 1280, 720).Project(under);
    ASSERT_TRUE(at.has_value());
    // kOrbit circles around a point slightly above the ground.
    EXPECT_NEAR(at->x, cursor.x, 14) << static_cast<int>(mode);
    EXPECT_NEAR(at->y, cursor.y, 14) << static_cast<int>(mode);
  }
}

TEST(CameraRig, GoesToAPlaceOnTheGroundAndNotToTheSky) {
  CameraRig rig;
  world::CameraSnapshot start;
  start.position = {0, 15, 30};
  start.orientation = {std::cos(0.25f), -std::sin(0.25f), 0, 0};
  rig.MoveTo(start);
  rig.GoTo({0, 0.2f, -0.98f});
  rig.Arrive();
  EXPECT_EQ(rig.pose().position, start.position);
  const Vec3 way = Projection(start, 1280, 720).RayThrough({300, 600});
  const Vec3 place = start.position + way * (15 / -way.y);
  rig.GoTo(way);
  rig.Arrive();
  const auto at = Projection(rig.pose(), 1280, 720).Project(place);
  ASSERT_TRUE(at.has_value());
  EXPECT_NEAR(at->x, 640, 2);
  EXPECT_NEAR(at->y, 360, 2);
  EXPECT_LT(world::Distance(rig.pose().position, place), world::Distance(start.position, place));
}

TEST(Picking, ABoxHoldsTheAgentsWhoseMiddleIsInIt) {
  const Projection view(CameraAt({0, 2, 10}), 800, 600);
  const std::vector<world::AgentSnapshot> agents{AgentAt(1, {-2, 2, 0}), AgentAt(2, {2, 2, 0}), AgentAt(3, {0, 2, 30})};
  EXPECT_THAT(view.AgentsIn({800, 600}, {0, 0}, agents), testing::ElementsAre(1, 2));
  EXPECT_THAT(view.AgentsIn({0, 0}, {400, 600}, agents), testing::ElementsAre(1));
}

TEST(Interpolate, GoesStraightButNeverThroughATeleport) {
  EXPECT_EQ(BetweenPositions({0, 0, 0}, {1, 0, 0}, 0.25f), (Vec3{0.25f, 0, 0}));
  EXPECT_EQ(BetweenPositions({0, 0, 0}, {50, 0, 0}, 0.25f), (Vec3{50, 0, 0}));
  const world::Quat turn{std::sqrt(0.5f), 0, std::sqrt(0.5f), 0};
  const world::Quat half = BetweenOrientations({}, {-turn.w, 0, -turn.y, 0}, 0.5f);
  EXPECT_NEAR(std::abs(half.w), std::cos(0.3927f), 1e-4);
}

world::UiSnapshot ButtonPanel(std::uint32_t id, float x, float y) {
  world::UiSnapshot panel;
  panel.id = id;
  panel.x = x;
  panel.y = y;
  panel.width = 100;
  panel.height = 40;
  panel.button = "button " + std::to_string(id);
  return panel;
}

TEST(ScriptButtons, TheUppermostOneThatIsVisibleIsFound) {
  world::SceneSnapshot scene;
  scene.ui = {ButtonPanel(1, 10, 500), ButtonPanel(2, 50, 500), ButtonPanel(3, 0, 0)};
  scene.ui[0].layer = 1;
  scene.ui[2].parent_id = 2;
  const Projection projection(world::CameraSnapshot{}, 800, 600);
  const ScreenRoom room{800, 600, 800, 600};
  const auto at = [&](float x, float y) {
    const auto* const found = ButtonAt(scene, room, projection, {x, y});
    return found != nullptr ? found->id : 0;
  };
  EXPECT_EQ(at(60, 510), 1u);   // Its layer is higher.
  EXPECT_EQ(at(120, 510), 3u);  // A child comes after its parent, at its place.
  EXPECT_EQ(at(5, 510), 0u);
  EXPECT_EQ(at(60, 541), 0u);
  scene.ui[0].visible = false;
  EXPECT_EQ(at(60, 510), 3u);
  scene.ui[2].button.clear();
  EXPECT_EQ(at(60, 510), 2u);
}

TEST(ScriptButtons, OneInTheWorldIsFoundWhereItIsDrawn) {
  world::SceneSnapshot scene;
  scene.ui = {ButtonPanel(1, 0, 0)};
  scene.ui[0].in_world = true;
  scene.ui[0].world_position = {0, 0, -5};  // Half a metre wide, 0.2 m high, to the right and down from here.
  const Projection projection(world::CameraSnapshot{{0, 0, 0}, {}, 45}, 800, 600);
  const ScreenRoom room{800, 600, 800, 600};
  EXPECT_NE(ButtonAt(scene, room, projection, {420, 310}), nullptr);
  EXPECT_EQ(ButtonAt(scene, room, projection, {380, 310}), nullptr);
  EXPECT_EQ(ButtonAt(scene, room, projection, {420, 290}), nullptr);
  scene.ui[0].world_position = {0, 0, 5};
  EXPECT_EQ(ButtonAt(scene, room, projection, {420, 310}), nullptr);
}

}  // namespace
}  // namespace soarbox::viewer
