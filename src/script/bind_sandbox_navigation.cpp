// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <lua.hpp>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/config_argument.h"

// Sandbox: navigation meshes.

namespace soarbox::script {
namespace {

using world::NavigationMesh;
using world::Vec3;

world::World& WorldOf(lua_State* state) {
  return ContextOf(state).world;
}

/// Returns the mesh with this name when it is ready; raises an error if there is none.
const NavigationMesh& MeshArgument(lua_State* state, int index) {
  const Result<const NavigationMesh*> mesh = WorldOf(state).navigation().Find(TextArgument(state, index));
  if (!mesh.ok()) RaiseDiagnostic(state, mesh.error());
  return *mesh.value();
}

/// (sandbox, name [, config])
int CreateNavigationMesh(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  const std::string_view name = TextArgument(state, 2);
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
    const double cells = WorldOf(state).NavigationCells(config);
    LuaMachine::Of(state).Charge(static_cast<std::uint64_t>(std::min(cells, NavigationMesh::kMaxCoveredCells) * 4));
  }
  const Result<bool> made = WorldOf(state).CreateNavigationMesh(name, config);
  if (!made.ok()) return RaiseDiagnostic(state, made.error());
  if (made.value()) WarnAtCaller(state, "fixed objects reach further than 100 m: the parts beyond are not walkable");
  return 0;
}

int SetDebugNavigationMesh(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  const Result<void> shown = WorldOf(state).navigation().Show(TextArgument(state, 2), TruthArgument(state, 3));
  return shown.ok() ? 0 : RaiseDiagnostic(state, shown.error());
}

int FindPath(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  luaL_checkstring(state, 2);
  const Vec3 from = CheckVector(state, 3), to = CheckVector(state, 4);
  LuaMachine::Of(state).Charge(200);
  const std::vector<Vec3> path = MeshArgument(state, 2).FindPath(from, to);
  lua_createtable(state, static_cast<int>(path.size()), 0);
  for (std::size_t i = 0; i < path.size(); ++i) {
    PushVector(state, path[i]);
    lua_rawseti(state, -2, static_cast<int>(i + 1));
  }
  return 1;
}

int FindClosestPoint(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  luaL_checkstring(state, 2);
  const Vec3 point = CheckVector(state, 3);
  PushVector(state, MeshArgument(state, 2).FindClosestPoint(point));
  return 1;
}

int RandomPoint(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  PushVector(state, MeshArgument(state, 2).RandomPoint(WorldOf(state).random()));
  return 1;
}

constexpr Binding kSandboxNavigationBindings[] = {
    {"CreateNavigationMesh", CreateNavigationMesh, 2, 3, WrongCount::kError},
    {"FindClosestPoint", FindClosestPoint, 3, 3, WrongCount::kError},
    {"FindPath", FindPath, 4, 4, WrongCount::kError},
    {"RandomPoint", RandomPoint, 2, 2, WrongCount::kError},
    {"SetDebugNavigationMesh", SetDebugNavigationMesh, 3, 3, WrongCount::kError},
};

}  // namespace

void BindSandboxNavigation(lua_State* state) {
  RegisterTable(state, "Sandbox", kSandboxNavigationBindings);
}

}  // namespace soarbox::script
