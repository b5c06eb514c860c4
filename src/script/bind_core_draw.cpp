// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/lua_machine.h"
#include "script/script_context.h"

// Core.Draw...: shapes that last for one step.

namespace soarbox::script {
namespace {

using world::Vec3;

world::DebugDraw& DebugOf(lua_State* state) {
  LuaMachine& machine = LuaMachine::Of(state);
  machine.Charge(100);
  const ScriptContext& context = *machine.context();
  world::DebugDraw& debug = context.world.debug();
  CheckRoom(state, debug.size(), context.budget.limits().shapes_per_tick, "lines and triangles for this step");
  return debug;
}

int DrawCircle(lua_State* state) {
  const Vec3 center = CheckVector(state, 1);
  const float radius = CheckFloat(state, 2);
  DebugOf(state).Circle(center, radius, CheckVector(state, 3));
  return 0;
}

int DrawLine(lua_State* state) {
  const Vec3 from = CheckVector(state, 1), to = CheckVector(state, 2);
  DebugOf(state).Line(from, to, CheckVector(state, 3));
  return 0;
}

/// The fourth argument is used only if it is the last one.
bool Filled(lua_State* state) {
  return lua_gettop(state) == 4 && TruthArgument(state, 4);
}

int DrawSphere(lua_State* state) {
  const Vec3 center = CheckVector(state, 1);
  const float radius = CheckFloat(state, 2);
  DebugOf(state).Sphere(center, radius, CheckVector(state, 3), Filled(state));
  return 0;
}

int DrawSquare(lua_State* state) {
  const Vec3 center = CheckVector(state, 1);
  const float side = CheckFloat(state, 2);
  DebugOf(state).Square(center, side, CheckVector(state, 3), Filled(state));
  return 0;
}

constexpr Binding kCoreDrawBindings[] = {
    {"DrawCircle", DrawCircle, 3, 3, WrongCount::kIgnored},
    {"DrawLine", DrawLine, 3, 3, WrongCount::kIgnored},
    {"DrawSphere", DrawSphere, 3, kAnyCount, WrongCount::kIgnored},
    {"DrawSquare", DrawSquare, 3, kAnyCount, WrongCount::kIgnored},
};

}  // namespace

void BindCoreDraw(lua_State* state) {
  RegisterTable(state, "Core", kCoreDrawBindings);
}

}  // namespace soarbox::script
