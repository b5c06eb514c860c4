// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <lua.hpp>

#include "script/api_call.h"
#include "script/config_argument.h"

// Sandbox: navigation meshes.

namespace soarbox::script {
namespace {

using world::NavigationMesh;
using world::Vec3;
using world::World;
using enum WrongCount;

/// Returns the mesh that argument 2 names, when it is ready; raises an error if there is none.
const NavigationMesh& NamedMesh(lua_State* state) {
  const Result<const NavigationMesh*> mesh = ContextOf(state).world.navigation().Find(TextArgument(state, 2));
  if (!mesh.ok()) RaiseDiagnostic(state, mesh.error());
  return *mesh.value();
}

/// (sandbox, name [, config])
int CreateNavigationMesh(lua_State* state) {
  const std::string_view name = TextArgument(state, 2);
  World& world = ContextOf(state).world;
  world::NavigationConfig config;
  ReadConfig(state, 3,
             {{"WalkableHeight", &config.walkable_height_m},
              {"WalkableRadius", &config.walkable_radius_m},
              {"WalkableClimbHeight", &config.climb_height_m},
              {"WalkableSlopeAngle", &config.slope_deg},
              {"MinimumRegionArea", &config.min_region_cells},
              {"MergeRegionArea", &config.merge_region_cells},
              {"CellSize", &config.cell_size_m},
              {"KeepsPoints", nullptr, nullptr, &config.keeps_points}});
  // In proportion to the work, so that a script cannot spend minutes on meshes.
  ChargeForCreation(state, Made::kOther);
  if (config.cell_size_m >= 0.05f) {
    const double cells = world.NavigationCells(config);
    LuaMachine::Of(state).Charge(static_cast<std::uint64_t>(std::min(cells, NavigationMesh::kMaxCoveredCells) * 4));
  }
  const Result<bool> made = world.CreateNavigationMesh(name, config);
  if (!made.ok()) return RaiseDiagnostic(state, made.error());
  if (made.value()) WarnAtCaller(state, "fixed objects reach further than 100 m: the parts beyond are not walkable");
  return 0;
}

int SetDebugNavigationMesh(lua_State* state) {
  const Result<void> shown =
      ContextOf(state).world.navigation().Show(TextArgument(state, 2), lua_toboolean(state, 3) != 0);
  return shown.ok() ? 0 : RaiseDiagnostic(state, shown.error());
}

std::vector<Vec3> FindPath(lua_State* state, World&, std::string_view, Vec3 from, Vec3 to) {
  LuaMachine::Of(state).Charge(200);
  return NamedMesh(state).FindPath(from, to);
}

Vec3 FindClosestPoint(lua_State* state, World&, std::string_view, Vec3 point) {
  return NamedMesh(state).FindClosestPoint(point);
}

Vec3 RandomPoint(lua_State* state, World& world, std::string_view) {
  return NamedMesh(state).RandomPoint(world.random());
}

constexpr ApiFunction kSandboxNavigationFunctions[] = {
    {"Sandbox.CreateNavigationMesh", CreateNavigationMesh, kError,
     "sandbox: Sandbox, name: string, settings: table = none", "",
     "Builds a mesh of the places where agents can walk on the present fixed objects (mass 0), except planes. It "
     "replaces a mesh with the same name. The mesh is built while the script continues; the first use waits for it. "
     "Settings, with their units and defaults: WalkableHeight (m; 1.6), WalkableRadius (m; 0.375), WalkableClimbHeight "
     "(m; 0.15), WalkableSlopeAngle (degrees; 45), MinimumRegionArea and MergeRegionArea (sides of squares in cells; "
     "50 and 100), CellSize (m; 0.1), KeepsPoints (if true, FindClosestPoint returns its argument, as in the first "
     "sandbox). Everything further than 100 m from the origin is ignored.",
     R"(Sandbox.CreateNavigationMesh(sandbox, "default", {WalkableRadius = 0.4, MinimumRegionArea = 10}))"},
    {"Sandbox.FindClosestPoint", kCall<FindClosestPoint>, kError, "sandbox: Sandbox, mesh: string, point: Vector [m]",
     "Vector [m]",
     "The nearest point on the mesh within 0.5 m sideways and 2 m up or down; the point itself if there is none.",
     R"(local floor = Sandbox.FindClosestPoint(sandbox, "default", agent:GetPosition())
print(floor.y < 0.2)  --> true)"},
    {"Sandbox.FindPath", kCall<FindPath>, kError, "sandbox: Sandbox, mesh: string, from: Vector [m], to: Vector [m]",
     "table of Vector [m]",
     "The shortest path on the mesh, with a point at each border between two polygons that it crosses. {} if there is "
     "no path, or if an end is more than 2 m sideways or 5 m up or down from the mesh.",
     R"(local path = Sandbox.FindPath(sandbox, "default", Vector.new(-5, 0, 0), Vector.new(-5, 0, 9))
agent:SetPath(path)
print(#path > 1)  --> true)"},
    {"Sandbox.RandomPoint", kCall<RandomPoint>, kError, "sandbox: Sandbox, mesh: string", "Vector [m]",
     "A random point on the mesh. All places are equally likely, even those that no path leads to.",
     R"(agent:SetTarget(Sandbox.RandomPoint(sandbox, "default")))"},
    {"Sandbox.SetDebugNavigationMesh", SetDebugNavigationMesh, kError, "sandbox: Sandbox, name: string, show: boolean",
     "", "Shows or hides a mesh.", R"(Sandbox.SetDebugNavigationMesh(sandbox, "default", true))"},
};

}  // namespace

std::span<const ApiFunction> SandboxNavigationApi() {
  return kSandboxNavigationFunctions;
}

}  // namespace soarbox::script
