// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"

// Sandbox: custom events and collision callbacks (spec 4.3, 4.4).

namespace soarbox::script {
namespace {

int AddEvent(lua_State* state) {
  const std::string_view type = TextArgument(state, 2);
  if (!SandboxArgument(state, 1)) return 0;
  LuaMachine::Of(state).Charge(100);
  ContextOf(state).events.Add(CopyEvent(state, type, 3));
  return 0;
}

int AddEventCallback(lua_State* state) {
  luaL_checktype(state, 3, LUA_TFUNCTION);
  if (!SandboxArgument(state, 1)) return 0;
  const Handle* target = ToHandle(state, 2);
  const bool can_hear = target && (target->kind == ValueKind::kAgent || target->kind == ValueKind::kObject ||
                                   target->kind == ValueKind::kSandbox);
  if (!can_hear) {
    WarnIgnored(state, "argument 2 is not an agent, an object or the sandbox");
    return 0;
  }
  if (target->kind == ValueKind::kObject) ObjectArgument(state, 2);
  LuaMachine& machine = LuaMachine::Of(state);
  lua_pushvalue(state, 3);
  ContextOf(state).events.SetCallback(*target, machine, luaL_ref(state, LUA_REGISTRYINDEX));
  return 0;
}

int AddCollisionCallback(lua_State* state) {
  luaL_checktype(state, 3, LUA_TFUNCTION);
  if (!SandboxArgument(state, 1)) return 0;
  const world::Object* object = ObjectArgument(state, 2);
  if (!object) return 0;
  LuaMachine& machine = LuaMachine::Of(state);
  lua_pushvalue(state, 3);
  ContextOf(state).collisions.Add(object->id(), machine, luaL_ref(state, LUA_REGISTRYINDEX));
  return 0;
}

constexpr Binding kBindings[] = {
    {"AddCollisionCallback", AddCollisionCallback, 3, 3, WrongCount::kIgnored},
    {"AddEvent", AddEvent, 3, 3, WrongCount::kError},
    {"AddEventCallback", AddEventCallback, 3, 3, WrongCount::kError},
};

}  // namespace

void BindSandboxEvents(lua_State* state) {
  RegisterTable(state, "Sandbox", kBindings);
}

}  // namespace soarbox::script
