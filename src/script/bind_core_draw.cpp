// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/api_call.h"
#include "script/lua_machine.h"

// Core.Draw...: shapes that last for one step.

namespace soarbox::script {
namespace {

using world::Vec3;
using enum WrongCount;

world::DebugDraw& DebugOf(lua_State* state) {
  LuaMachine& machine = LuaMachine::Of(state);
  machine.Charge(100);
  const ScriptContext& context = *machine.context();
  world::DebugDraw& debug = context.world.debug();
  CheckRoom(state, debug.size(), context.budget.limits().shapes_per_tick, "lines and triangles for this step");
  return debug;
}

void DrawCircle(lua_State* state, Vec3 center, float radius, Vec3 color) {
  DebugOf(state).Circle(center, radius, color);
}

void DrawLine(lua_State* state, Vec3 from, Vec3 to, Vec3 color) {
  DebugOf(state).Line(from, to, color);
}

/// `filled` is used only if it is the last argument.
template <auto kDraw>
void DrawFilled(lua_State* state, Vec3 center, float size, Vec3 color, bool filled) {
  (DebugOf(state).*kDraw)(center, size, color, filled && lua_gettop(state) == 4);
}

constexpr ApiFunction kCoreDrawFunctions[] = {
    {"Core.DrawCircle", kCall<DrawCircle>, kIgnored, "center: Vector [m], radius: number 0..1e30 [m], color: Vector",
     "", "Draws a horizontal circle for one step.", R"(Core.DrawCircle(agent:GetTarget(), 1, Vector.new(1, 0, 0)))"},
    {"Core.DrawLine", kCall<DrawLine>, kIgnored, "from: Vector [m], to: Vector [m], color: Vector", "",
     "Draws a line for one step.", R"(Core.DrawLine(agent:GetPosition(), agent:GetTarget(), Vector.new(0, 1, 0)))"},
    {"Core.DrawSphere", kCall<DrawFilled<&world::DebugDraw::Sphere>>, kIgnored,
     "center: Vector [m], radius: number 0..1e30 [m], color: Vector, filled: boolean = false", "",
     "Draws a wire sphere for one step; if filled, it is translucent inside.",
     R"(Core.DrawSphere(agent:GetPosition(), 1, Vector.new(0, 0, 1), true))", false, kAnyCount},
    {"Core.DrawSquare", kCall<DrawFilled<&world::DebugDraw::Square>>, kIgnored,
     "center: Vector [m], side: number 0..1e6 [m], color: Vector, filled: boolean = false", "",
     "Draws a horizontal square for one step.", R"(Core.DrawSquare(Vector.new(), 100, Vector.new(1, 0, 0)))", false,
     kAnyCount},
};

}  // namespace

std::span<const ApiFunction> CoreDrawApi() {
  return kCoreDrawFunctions;
}

}  // namespace soarbox::script
