// SPDX-License-Identifier: BSD-2-Clause
#include <DetourAlloc.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>
#include <thread>

#include "diagnostics/without_threads.h"
#include "world/navigation_files.h"
#include "world/navigation_mesh.h"
#include "world/navigation_store.h"
#include "world/shared_navigation.h"
#include "world/world.h"

namespace soarbox::world {
namespace {

EntityId AddFixedBox(World& world, Vec3 size, Vec3 position) {
  const EntityId id = world.CreateBox(size.x, size.y, size.z);
  world.FindObject(id)->SetMass(0);
  world.FindObject(id)->SetPosition(position);
  return id;
}

float LengthOf(const std::vector<Vec3>& path) {
  float length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += Distance(path[i - 1], path[i]);
  return length;
}

/// A floor of 20 by 20 m with its top at y = 0, and a wall across it with a gap of 4 m at one end.
class NavigationTest : public testing::Test {
 protected:
  NavigationTest() {
    AddFixedBox(world_, {20, 1, 20}, {0, -0.5f, 0});
    AddFixedBox(world_, {16, 2, 1}, {-2, 1, 0});
    config_.min_region_cells = 10;
  }
  const NavigationMesh& Make(const NavigationConfig& config, std::string_view name = "default") {
    const Result<bool> made = world_.CreateNavigationMesh(name, config);
    EXPECT_TRUE(made.ok()) << made.error().message;
    const Result<const NavigationMesh*> mesh = world_.navigation().Find(name);
    EXPECT_TRUE(mesh.ok()) << mesh.error().message;
    return *mesh.value();
  }
  World world_;
  NavigationConfig config_;
};

TEST_F(NavigationTest, WhereNoThreadCanBeStartedTheMeshIsBuiltWhenItIsNeeded) {
  const WithoutThreads none;
  ASSERT_THROW(std::thread([] {}).join(), std::system_error);
  EXPECT_GE(Make(config_).FindPath({-8, 0, -5}, {-8, 0, 5}).size(), 3u);
}

TEST_F(NavigationTest, PathsLeadThroughTheGapAndKeepTheRadiusFromTheWall) {
  const NavigationMesh& mesh = Make(config_);
  const std::vector<Vec3> path = mesh.FindPath({-8, 0, -5}, {-8, 0, 5});
  ASSERT_GE(path.size(), 3u);
  EXPECT_GT(LengthOf(path), 29.0f) << "around the wall, not through it";
  EXPECT_LT(LengthOf(path), 32.5f);
  for (const Vec3 point : path) {
    EXPECT_NEAR(point.y, 0.05f, 0.051f);
    EXPECT_FALSE(point.x < 6.3f && std::abs(point.z) < 0.75f) << point.x << " " << point.z;
  }
  EXPECT_NEAR(path.front().x, -8, 0.01f);
  EXPECT_NEAR(path.back().z, 5, 0.01f);
}

TEST_F(NavigationTest, APlaceWithinWallsIsOutOfReachAndOnlyThat) {
  // An enclosure of 4 by 4 m behind the wall.
  AddFixedBox(world_, {4.5f, 2, 0.5f}, {-6, 1, 4});
  AddFixedBox(world_, {4.5f, 2, 0.5f}, {-6, 1, 8});
  AddFixedBox(world_, {0.5f, 2, 4.5f}, {-8, 1, 6});
  AddFixedBox(world_, {0.5f, 2, 4.5f}, {-4, 1, 6});
  const NavigationMesh& mesh = Make(config_);
  const Vec3 pen{-6, 0, 6}, outside{0, 0, 6}, far_side{-6, 0, -5};
  for (const Vec3 from : {outside, far_side}) {
    EXPECT_FALSE(mesh.MayReach(from, pen, 1));
    EXPECT_TRUE(mesh.MayReach(from, pen, 4)) << "so far counts as there";
    EXPECT_FALSE(mesh.MayReach(pen, from, 1)) << "nor out of it";
  }
  EXPECT_TRUE(mesh.MayReach(outside, far_side, 1));
  EXPECT_TRUE(mesh.MayReach(pen, {-6.5f, 0, 5.5f}, 0.1f));
  EXPECT_FALSE(mesh.MayReach(outside, {-8, 1, 6}, 0.3f)) << "inside a wall";
  EXPECT_TRUE(mesh.MayReach(outside, {40, 0, 0}, 1)) << "beyond the mesh";
  EXPECT_TRUE(mesh.MayReach({40, 0, 0}, pen, 1)) << "from beyond it";
  EXPECT_TRUE(mesh.MayReach(outside, {std::numeric_limits<float>::quiet_NaN(), 0, 0}, 1));
}

TEST_F(NavigationTest, ThereIsNoPathFromOrToPlacesFarFromTheMesh) {
  const NavigationMesh& mesh = Make(config_);
  EXPECT_TRUE(mesh.FindPath({0, 0, -5}, {50, 0, 0}).empty());
  EXPECT_TRUE(mesh.FindPath({0, 20, -5}, {0, 0, 5}).empty());
  EXPECT_TRUE(mesh.FindPath({std::numeric_limits<float>::quiet_NaN(), 0, 0}, {0, 0, 5}).empty());
  EXPECT_FALSE(mesh.FindPath({11, 0, -5}, {0, 0, 5}).empty()) << "within 2 m is near enough";
}

TEST_F(NavigationTest, WiderAgentsDoNotFitThroughTheGap) {
  config_.walkable_radius_m = 2.5f;
  EXPECT_TRUE(Make(config_).FindPath({-5, 0, -5}, {-5, 0, 5}).empty());
}

/// Closes the gap with posts and this building piece. Returns the number of corners of the path to the other side.
std::size_t CornersThrough(World& world, const char* piece, float middle_y) {
  AddFixedBox(world, {1, 2, 1}, {6.3f, 1, 0});
  AddFixedBox(world, {1, 2, 1}, {9.7f, 1, 0});
  const EntityId id = world.CreateObject("models/nobiax_modular/" + std::string(piece) + ".mesh");
  world.FindObject(id)->SetMass(0);
  world.FindObject(id)->SetPosition({8, middle_y, 0});
  NavigationConfig config;
  config.min_region_cells = 10;
  config.walkable_radius_m = 0.3f;
  EXPECT_TRUE(world.CreateNavigationMesh("through", config).ok());
  return world.navigation().Find("through").value()->FindPath({8, 0, -5}, {8, 0, 5}).size();
}

TEST_F(NavigationTest, WaysLeadThroughDoorsAndNotThroughWalls) {
  EXPECT_GE(CornersThrough(world_, "modular_brick_door", 0.77f), 2u);
  // The body has the same opening as the mesh: no obstacle in it, a lintel above and a post beside it.
  EXPECT_FALSE(world_.RayCast({8, 1, -2}, {8, 1, 2}));
  EXPECT_TRUE(world_.RayCast({8, 2.3f, -2}, {8, 2.3f, 2}));
  EXPECT_TRUE(world_.RayCast({7.1f, 1, -2}, {7.1f, 1, 2}));
}

TEST_F(NavigationTest, AWallInTheGapClosesTheWay) {
  EXPECT_EQ(CornersThrough(world_, "modular_wall_brick_1", 1.28f), 0u);
}

TEST_F(NavigationTest, StepsAreClimbedUpToTheClimbHeight) {
  AddFixedBox(world_, {4, 0.3f, 4}, {5, 0.15f, 5});
  EXPECT_LT(LengthOf(Make(config_).FindPath({0, 0, 5}, {5, 0.3f, 5})), 5.0f) << "an end below is nearer than one above";
  EXPECT_LT(Make(config_).FindPath({0, 0, 8}, {5, 0.4f, 5}).size(), 2u) << "0.3 m is too high a step";
  config_.climb_height_m = 0.4f;
  const std::vector<Vec3> path = Make(config_).FindPath({0, 0, 8}, {5, 0.4f, 5});
  ASSERT_GE(path.size(), 2u);
  EXPECT_NEAR(path.back().y, 0.35f, 0.1f);
}

TEST_F(NavigationTest, RampsAreWalkedUpToTheSlope) {
  World world;
  AddFixedBox(world, {20, 1, 20}, {0, -0.5f, 0});
  const EntityId ramp = AddFixedBox(world, {6, 1, 12}, {0, 0.5f, 0});
  world.FindObject(ramp)->SetOrientation({0.9659258f, -0.258819f, 0, 0});  // 30 degrees about x.
  NavigationConfig config;
  config.climb_height_m = 0.2f;
  ASSERT_TRUE(world.CreateNavigationMesh("steep", config).ok());
  EXPECT_GT((*world.navigation().Find("steep"))->max().y, 2.0f);
  config.slope_deg = 20;
  ASSERT_TRUE(world.CreateNavigationMesh("flat", config).ok());
  EXPECT_LT((*world.navigation().Find("flat"))->max().y, 1.0f);
}

TEST_F(NavigationTest, TheClosestPointIsOnTheMeshOrThePointItself) {
  const NavigationMesh& mesh = Make(config_);
  const Vec3 found = mesh.FindClosestPoint({3, 0.8f, 5});
  EXPECT_NEAR(found.y, 0.05f, 0.051f);
  EXPECT_FLOAT_EQ(found.x, 3);
  EXPECT_EQ(mesh.FindClosestPoint({3, 40, 5}), (Vec3{3, 40, 5}));
  config_.keeps_points = true;
  EXPECT_EQ(Make(config_).FindClosestPoint({3, 0.8f, 5}), (Vec3{3, 0.8f, 5}));
}

TEST_F(NavigationTest, RandomPointsLieOnTheMeshAndCoverIt) {
  const NavigationMesh& mesh = Make(config_);
  EXPECT_NEAR(mesh.area_m2(), 19.2f * 19.2f - 16.8f * 1.8f, 15.0f);
  int beyond = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 point = mesh.RandomPoint(world_.random());
    EXPECT_LT(std::max(std::abs(point.x), std::abs(point.z)), 9.7f);
    EXPECT_FALSE(point.x < 6.2f && std::abs(point.z) < 0.7f) << point.x << " " << point.z;
    if (point.z > 0) ++beyond;
  }
  EXPECT_NEAR(beyond, 500, 80);
}

TEST_F(NavigationTest, TheSameWorldGivesTheSameMeshAndPoints) {
  const auto make = [](std::uint64_t seed, std::vector<Vec3>& points) {
    WorldSettings settings;
    settings.seed = seed;
    World world(settings);
    AddFixedBox(world, {30, 1, 30}, {0, -0.5f, 0});
    AddFixedBox(world, {3, 3, 3}, {2, 1, 7});
    EXPECT_TRUE(world.CreateNavigationMesh("default", {}).ok());
    const std::uint64_t before = world.Hash();
    const NavigationMesh& mesh = **world.navigation().Find("default");
    EXPECT_EQ(world.Hash(), before) << "whether a mesh is ready is not a state of the world";
    for (int i = 0; i < 20; ++i) points.push_back(mesh.RandomPoint(world.random()));
    for (const Vec3 point : mesh.FindPath({-10, 0, -10}, {10, 0, 12})) points.push_back(point);
    return world.Hash();
  };
  std::vector<Vec3> a, b, c;
  EXPECT_EQ(make(5, a), make(5, b));
  EXPECT_EQ(a, b);
  make(6, c);
  EXPECT_NE(a, c);
}

TEST(SharedNavigation, AMeshThatAnotherProcessBuiltIsTheOneThatWouldBeBuiltHere) {
  NavigationGeometry geometry;
  geometry.AddBox({}, {10, 0.5f, 10}, {0, -0.5f, 0}, {});
  geometry.AddBox({}, {1, 1, 1}, {3, 1, 2}, {});
  NavigationConfig config;
  const std::uint64_t source = SourceHash(geometry, config);
  ShareNavigation();
  EXPECT_FALSE(FindSharedNavigation(source).has_value());
  const pid_t child = fork();
  if (child == 0) _exit(NavigationMesh::Build(geometry, config).ok() ? 0 : 1);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
  std::optional<BuiltNavigation> found = FindSharedNavigation(source);
  ASSERT_TRUE(found.has_value());
  Result<BuiltNavigation> built = BuildNavigation(geometry, config);
  ASSERT_TRUE(built.ok());
  ASSERT_EQ(found->tile_size, built->tile_size);
  EXPECT_EQ(std::memcmp(found->tile, built->tile, static_cast<std::size_t>(built->tile_size)), 0);
  EXPECT_EQ(found->triangles, built->triangles);
  dtFree(found->tile);
  dtFree(built->tile);
  // A mesh built from it works; another source gives another mesh.
  const Result<std::unique_ptr<NavigationMesh>> mesh = NavigationMesh::Build(geometry, config);
  ASSERT_TRUE(mesh.ok());
  EXPECT_GE((*mesh)->FindPath({0, 0, 2}, {6, 0, 2}).size(), 2u);
  config.walkable_radius_m = 0.6f;
  EXPECT_FALSE(FindSharedNavigation(SourceHash(geometry, config)).has_value());
}

TEST(KeptNavigation, AMeshInAFileIsTheOneThatWouldBeBuiltHere) {
  namespace fs = std::filesystem;
  NavigationGeometry geometry;
  geometry.AddBox({}, {12, 0.5f, 12}, {0, -0.5f, 0}, {});
  const NavigationConfig config;
  const std::uint64_t source = SourceHash(geometry, config);
  const fs::path folder = fs::temp_directory_path() / ("soarbox-kept-navigation-" + std::to_string(getpid()));
  KeepNavigation(folder, "this program");
  Result<BuiltNavigation> built = BuildNavigation(geometry, config);
  ASSERT_TRUE(built.ok());
  EXPECT_FALSE(FindKeptNavigation(source).has_value());
  KeepBuiltNavigation(source, *built);
  const std::optional<BuiltNavigation> found = FindKeptNavigation(source);
  ASSERT_TRUE(found.has_value());
  ASSERT_EQ(found->tile_size, built->tile_size);
  EXPECT_EQ(std::memcmp(found->tile, built->tile, static_cast<std::size_t>(built->tile_size)), 0);
  EXPECT_EQ(found->triangles, built->triangles);
  dtFree(found->tile);
  EXPECT_FALSE(FindKeptNavigation(source + 64).has_value()) << "its file holds another mesh";
  KeepNavigation(folder, "another program");
  EXPECT_FALSE(FindKeptNavigation(source).has_value());
  KeepNavigation(folder, "this program");
  // There is exactly one file, without an incomplete one.
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  ASSERT_EQ(files.size(), 1u);
  std::fstream file(files.front(), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(200);
  file.put('?').put('!');
  file.close();
  EXPECT_FALSE(FindKeptNavigation(source).has_value()) << "it is damaged";
  fs::resize_file(files.front(), 100);
  EXPECT_FALSE(FindKeptNavigation(source).has_value()) << "it ends too soon";
  KeepNavigation({}, {});
  KeepBuiltNavigation(source, *built);
  EXPECT_FALSE(FindKeptNavigation(source).has_value());
  dtFree(built->tile);
  fs::remove_all(folder);
}

TEST_F(NavigationTest, FaultsAreNamed) {
  const auto message = [](const auto& result) {
    return result.ok() ? std::string("no error") : result.error().message;
  };
  EXPECT_EQ(message(world_.navigation().Find("nowhere")), "there is no navigation mesh \"nowhere\"");
  Make(config_, "default");
  EXPECT_EQ(world_.navigation().Find("defualt").error().hint, "did you mean \"default\"?");
  EXPECT_EQ(message(world_.navigation().Show("nowhere", true)), "there is no navigation mesh \"nowhere\"");

  NavigationConfig absurd;
  absurd.walkable_radius_m = -1;
  EXPECT_EQ(message(world_.CreateNavigationMesh("a", absurd)), "WalkableRadius is -1");
  absurd = {};
  absurd.cell_size_m = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(message(world_.CreateNavigationMesh("a", absurd)), "CellSize is nan");
  absurd = {};
  absurd.walkable_radius_m = 40;
  ASSERT_TRUE(world_.CreateNavigationMesh("wide", absurd).ok());
  EXPECT_EQ(message(world_.navigation().Find("wide")),
            "the navigation mesh \"wide\" could not be made: nothing in this world is walkable for such an agent");

  World empty;
  empty.CreatePlane(100, 100);
  EXPECT_EQ(message(empty.CreateNavigationMesh("a", {})), "there is no fixed object to walk on");
  World far;
  AddFixedBox(far, {1, 1, 1}, {5000, 0, 0});
  ASSERT_TRUE(far.CreateNavigationMesh("a", {}).ok());
  EXPECT_NE(message(far.navigation().Find("a")), "no error");
  World giant;
  for (int i = 0; i < 4; ++i) AddFixedBox(giant, {5000, 1, 5000}, {0, static_cast<float>(i) * 10, 0});
  EXPECT_EQ(message(giant.CreateNavigationMesh("a", {})),
            "the fixed objects are too many or too large for one navigation mesh");
  NavigationConfig coarse;
  coarse.cell_size_m = 1;
  coarse.min_region_cells = 2;
  EXPECT_TRUE(giant.CreateNavigationMesh("a", coarse).value()) << "much of it lies too far out";
  EXPECT_EQ(message(giant.navigation().Find("a")), "no error");
  World small;
  AddFixedBox(small, {5, 1, 5}, {});
  EXPECT_FALSE(small.CreateNavigationMesh("mesh 0", coarse).value());
  for (int i = 0; i < 40; ++i) (void)small.CreateNavigationMesh("mesh " + std::to_string(i), coarse);
  EXPECT_EQ(message(small.CreateNavigationMesh("one more", coarse)), "there are 32 navigation meshes already");
}

TEST_F(NavigationTest, AMeshThatIsShownIsInTheSnapshot) {
  Make(config_);
  EXPECT_TRUE(world_.Snapshot().triangles.empty());
  ASSERT_TRUE(world_.navigation().Show("default", true).ok());
  const SceneSnapshot snapshot = world_.Snapshot();
  EXPECT_EQ(snapshot.lines.size(), 3 * snapshot.triangles.size());
  ASSERT_FALSE(snapshot.triangles.empty());
  EXPECT_FLOAT_EQ(snapshot.triangles[0].color.a, 32.0f / 255);
  ASSERT_TRUE(world_.navigation().Show("default", false).ok());
  EXPECT_TRUE(world_.Snapshot().triangles.empty());
}

TEST_F(NavigationTest, AWorldMayGoWhileItsMeshIsBeingBuilt) {
  auto world = std::make_unique<World>();
  AddFixedBox(*world, {100, 1, 100}, {0, 0, 0});
  ASSERT_TRUE(world->CreateNavigationMesh("default", {}).ok());
}

TEST_F(NavigationTest, CapsulesAndTurnedBoxesAreObstacles) {
  World world;
  AddFixedBox(world, {20, 1, 20}, {0, -0.5f, 0});
  const EntityId pillar = world.CreateCapsule(4, 1.5f);
  world.FindObject(pillar)->SetMass(0);
  NavigationConfig config;
  config.min_region_cells = 10;
  ASSERT_TRUE(world.CreateNavigationMesh("default", config).ok());
  const std::vector<Vec3> path = (*world.navigation().Find("default"))->FindPath({-6, 0, 0}, {6, 0, 0});
  ASSERT_GE(path.size(), 2u);
  EXPECT_GT(LengthOf(path), 12.4f) << "around the pillar";
  for (const Vec3 point : path) EXPECT_GT(std::hypot(point.x, point.z), 1.6f);
}

}  // namespace
}  // namespace soarbox::world
