// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/api_call.h"
#include "script/argument_check.h"
#include "script/config_argument.h"

// Sandbox: the influence map.

namespace soarbox::script {
namespace {

using world::InfluenceMap;
using world::Vec3;
using world::World;
using enum WrongCount;

/// Returns the sandbox's map; raises an error if there is none.
InfluenceMap& MapOf(lua_State* state) {
  InfluenceMap* map = ContextOf(state).world.influence();
  if (!map) luaL_error(state, "there is no influence map yet (make one with Sandbox.CreateInfluenceMap)");
  return *map;
}

/// Returns the layer in argument 2.
int LayerOf(lua_State* state) {
  const double layer = luaL_checknumber(state, 2);
  if (!(layer >= 0 && layer < InfluenceMap::kLayers)) ArgumentError(state, 2, "a layer is a number from 0 to 9");
  return static_cast<int>(layer);
}

/// (sandbox, navigation mesh [, config])
int CreateInfluenceMap(lua_State* state) {
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

/// Calls the function of the map with the layer in argument 2 and the values.
template <auto kSet, class... Values>
void SetLayer(lua_State* state, const World&, double, Values... values) {
  const int layer = LayerOf(state);  // Its errors come first.
  (MapOf(state).*kSet)(layer, values...);
}

float GetInfluence(lua_State* state, World& world, double, Vec3 position) {
  const int layer = LayerOf(state);
  return world.influence() ? world.influence()->Get(layer, position) : 0;
}

void SpreadInfluenceMap(lua_State* state, const World&, double) {
  const int layer = LayerOf(state);
  InfluenceMap& map = MapOf(state);
  // Twenty passes over each cell and its neighbours.
  LuaMachine::Of(state).Charge(static_cast<std::uint64_t>(map.used_cells()) * 20);
  map.Spread(layer);
}

/// (sandbox, layer, colour of 1, colour of 0, colour of -1)
int DrawInfluenceMap(lua_State* state) {
  const int layer = LayerOf(state);
  const world::Color positive = ColorArgument(state, 3), neutral = ColorArgument(state, 4),
                     negative = ColorArgument(state, 5);
  InfluenceMap& map = MapOf(state);
  LuaMachine::Of(state).Charge(static_cast<std::uint64_t>(map.used_cells()));
  map.Draw(layer, positive, neutral, negative);
  return 0;
}

void SetDrawInfluenceMap(lua_State* state, const World&, bool draw) {
  MapOf(state).SetVisible(draw);
}

constexpr ApiFunction kSandboxInfluenceFunctions[] = {
    {"Sandbox.ClearInfluenceMap", kCall<SetLayer<&InfluenceMap::Clear>>, kError, "sandbox: Sandbox, layer: number", "",
     "Sets all cells of a layer to 0.", R"(Sandbox.ClearInfluenceMap(sandbox, 0))"},
    {"Sandbox.CreateInfluenceMap", CreateInfluenceMap, kError, "sandbox: Sandbox, mesh: string, settings: table = none",
     "",
     "Lays a grid with ten layers, 0 to 9, over a navigation mesh, and replaces the previous grid. Settings: CellWidth "
     "and CellHeight (m; both are required), BoundaryMinOffset and BoundaryMaxOffset (vectors, m, added to the corners "
     "of the mesh's bounding box).",
     R"(Sandbox.CreateInfluenceMap(sandbox, "default", {CellWidth = 2, CellHeight = 1}))"},
    {"Sandbox.DrawInfluenceMap", DrawInfluenceMap, kError,
     "sandbox: Sandbox, layer: number, positive: table, neutral: table, negative: table", "",
     "Colours the cells by their present values, until the next call. The three colours are those of the values 1, 0 "
     "and -1: {red, green, blue, alpha}.",
     R"(Sandbox.DrawInfluenceMap(sandbox, 0, {1, 0, 0, 0.9}, {0, 0, 0, 0.75}, {0, 0, 1, 0.9}))"},
    {"Sandbox.GetInertia", kCall<GetInfluence>, kError, "sandbox: Sandbox, layer: number, position: Vector [m]",
     "number", "The same as GetInfluence: its name in the first sandbox.",
     R"(print(Sandbox.GetInertia(sandbox, 0, Vector.new()))  --> 0)"},
    {"Sandbox.GetInfluence", kCall<GetInfluence>, kError, "sandbox: Sandbox, layer: number, position: Vector [m]",
     "number", "The value of the cell at a place, -1 to 1; 0 off the map.",
     R"(Sandbox.SetInfluence(sandbox, 0, agent:GetPosition(), 0.5)
print(Sandbox.GetInfluence(sandbox, 0, agent:GetPosition()))  --> 0.5)",
     true},
    {"Sandbox.SetDrawInfluenceMap", kCall<SetDrawInfluenceMap>, kError, "sandbox: Sandbox, show: boolean", "",
     "Shows or hides the cells that DrawInfluenceMap coloured.", R"(Sandbox.SetDrawInfluenceMap(sandbox, false))"},
    {"Sandbox.SetFalloff", kCall<SetLayer<&InfluenceMap::SetFalloff, float>>, kError,
     "sandbox: Sandbox, layer: number, falloff: number 0..1", "",
     "The fraction of an influence that is lost from cell to cell, 0 to 1; initially 0.",
     R"(Sandbox.SetFalloff(sandbox, 0, 0.2))"},
    {"Sandbox.SetInertia", kCall<SetLayer<&InfluenceMap::SetInertia, float>>, kError,
     "sandbox: Sandbox, layer: number, inertia: number 0..1", "",
     "The fraction of its value that a cell keeps while influences spread, 0 to 1; initially 0.",
     R"(Sandbox.SetInertia(sandbox, 0, 0.5))"},
    {"Sandbox.SetInfluence", kCall<SetLayer<&InfluenceMap::Set, Vec3, float>>, kError,
     "sandbox: Sandbox, layer: number, position: Vector [m], value: number -1..1", "",
     "Sets the cell at a place to a value from -1 to 1. Places off the mesh are ignored; FindClosestPoint finds one on "
     "the mesh.",
     R"(local place = Sandbox.FindClosestPoint(sandbox, "default", agent:GetPosition())
Sandbox.SetInfluence(sandbox, 0, place, 1))"},
    {"Sandbox.SpreadInfluenceMap", kCall<SpreadInfluenceMap>, kError, "sandbox: Sandbox, layer: number", "",
     "Spreads the influences of a layer to the surrounding cells, weaker with each cell.",
     R"(Sandbox.SetFalloff(sandbox, 0, 0.2)
Sandbox.SetInfluence(sandbox, 0, Vector.new(-5, 0.5, 5), 1)
Sandbox.SpreadInfluenceMap(sandbox, 0)
print(Sandbox.GetInfluence(sandbox, 0, Vector.new(-7, 0.5, 5)) > 0.7)  --> true)"},
};

}  // namespace

std::span<const ApiFunction> SandboxInfluenceApi() {
  return kSandboxInfluenceFunctions;
}

}  // namespace soarbox::script
