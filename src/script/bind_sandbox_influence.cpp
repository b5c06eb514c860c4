// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/argument_check.h"
#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/config_argument.h"

// Sandbox: the influence map.

namespace soarbox::script {
namespace {

using world::InfluenceMap;

/// Returns the sandbox's map; raises an error if there is none.
InfluenceMap& MapOf(lua_State* state) {
  InfluenceMap* map = ContextOf(state).world.influence();
  if (!map) luaL_error(state, "there is no influence map yet (make one with Sandbox.CreateInfluenceMap)");
  return *map;
}

int LayerArgument(lua_State* state, int index) {
  const double layer = luaL_checknumber(state, index);
  if (!(layer >= 0 && layer < InfluenceMap::kLayers)) ArgumentError(state, index, "a layer is a number from 0 to 9");
  return static_cast<int>(layer);
}

/// (sandbox, navigation mesh [, config])
int CreateInfluenceMap(lua_State* state) {
  if (!SandboxArgument(state, 1)) return 0;
  const std::string_view mesh = TextArgument(state, 2);
  world::InfluenceConfig config;
  ReadConfig(state, 3,
             {{"CellWidth", &config.cell_width_m},
              {"CellHeight", &config.cell_height_m},
              {"BoundaryMinOffset", nullptr, &config.min_offset},
              {"BoundaryMaxOffset", nullptr, &config.max_offset}});
  LuaMachine::Of(state).Charge(1'000'000);
  const Result<void> made = ContextOf(state).world.CreateInfluenceMap(mesh, config);
  return made.ok() ? 0 : RaiseDiagnostic(state, made.error());
}

int ClearInfluenceMap(lua_State* state) {
  const int layer = LayerArgument(state, 2);
  if (SandboxArgument(state, 1)) MapOf(state).Clear(layer);
  return 0;
}

/// (sandbox, layer, position, value); ignores places outside of the map, because agents are often next to it.
int SetInfluence(lua_State* state) {
  const int layer = LayerArgument(state, 2);
  const world::Vec3 position = CheckVector(state, 3);
  const float value = CheckFloat(state, 4);
  if (SandboxArgument(state, 1)) MapOf(state).Set(layer, position, value);
  return 0;
}

int GetInfluence(lua_State* state) {
  const int layer = LayerArgument(state, 2);
  const world::Vec3 position = CheckVector(state, 3);
  if (!SandboxArgument(state, 1)) return 0;
  const InfluenceMap* map = ContextOf(state).world.influence();
  lua_pushnumber(state, map ? map->Get(layer, position) : 0);
  return 1;
}

int SetFalloff(lua_State* state) {
  const int layer = LayerArgument(state, 2);
  const float falloff = CheckFloat(state, 3);
  if (SandboxArgument(state, 1)) MapOf(state).SetFalloff(layer, falloff);
  return 0;
}

int SetInertia(lua_State* state) {
  const int layer = LayerArgument(state, 2);
  const float inertia = CheckFloat(state, 3);
  if (SandboxArgument(state, 1)) MapOf(state).SetInertia(layer, inertia);
  return 0;
}

int SpreadInfluenceMap(lua_State* state) {
  const int layer = LayerArgument(state, 2);
  if (!SandboxArgument(state, 1)) return 0;
  InfluenceMap& map = MapOf(state);
  // Twenty passes over each cell and its neighbours.
  LuaMachine::Of(state).Charge(static_cast<std::uint64_t>(map.used_cells()) * 20);
  map.Spread(layer);
  return 0;
}

/// (sandbox, layer, colour of 1, colour of 0, colour of -1)
int DrawInfluenceMap(lua_State* state) {
  const int layer = LayerArgument(state, 2);
  const world::Color positive = ColorArgument(state, 3), neutral = ColorArgument(state, 4),
                     negative = ColorArgument(state, 5);
  if (!SandboxArgument(state, 1)) return 0;
  InfluenceMap& map = MapOf(state);
  LuaMachine::Of(state).Charge(static_cast<std::uint64_t>(map.used_cells()));
  map.Draw(layer, positive, neutral, negative);
  return 0;
}

int SetDrawInfluenceMap(lua_State* state) {
  if (SandboxArgument(state, 1)) MapOf(state).SetVisible(TruthArgument(state, 2));
  return 0;
}

constexpr Binding kSandboxInfluenceBindings[] = {
    {"ClearInfluenceMap", ClearInfluenceMap, 2, 2, WrongCount::kError},
    {"CreateInfluenceMap", CreateInfluenceMap, 2, 3, WrongCount::kError},
    {"DrawInfluenceMap", DrawInfluenceMap, 5, 5, WrongCount::kError},
    {"GetInertia", GetInfluence, 3, 3, WrongCount::kError},
    {"GetInfluence", GetInfluence, 3, 3, WrongCount::kError},
    {"SetDrawInfluenceMap", SetDrawInfluenceMap, 2, 2, WrongCount::kError},
    {"SetFalloff", SetFalloff, 3, 3, WrongCount::kError},
    {"SetInertia", SetInertia, 3, 3, WrongCount::kError},
    {"SetInfluence", SetInfluence, 4, 4, WrongCount::kError},
    {"SpreadInfluenceMap", SpreadInfluenceMap, 2, 2, WrongCount::kError},
};

}  // namespace

void BindSandboxInfluence(lua_State* state) {
  RegisterTable(state, "Sandbox", kSandboxInfluenceBindings);
}

}  // namespace soarbox::script
