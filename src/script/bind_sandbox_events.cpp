// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/bind_api.h"
#include "script/bind_arguments.h"
#include "script/binding.h"
#include "script/lua_machine.h"
#include "script/script_path.h"

// Sandbox: custom events and collision callbacks (lua_api.md 4.3, 4.4).

namespace soarbox::script {
namespace {

/// A separate function, so that no C++ string is alive when the error is raised.
int RaiseFull(lua_State* state) {
  return luaL_error(state, "the waiting events of this world already hold %d MB: no more are accepted",
                    static_cast<int>(ContextOf(state).budget.limits().event_bytes >> 20));
}

void CheckCallbacks(lua_State* state) {
  const ScriptContext& context = ContextOf(state);
  CheckRoom(state, context.events.callbacks() + context.collisions.size(), context.budget.limits().callbacks,
            "callbacks");
}

int AddEvent(lua_State* state) {
  const std::string_view type = TextArgument(state, 2);
  if (!SandboxArgument(state, 1)) return 0;
  LuaMachine::Of(state).Charge(100);
  EventQueue& events = ContextOf(state).events;
  const WorldLimits& limits = ContextOf(state).budget.limits();
  CheckRoom(state, events.waiting(), limits.waiting_events, "waiting events");
  ScriptEvent event = CopyEvent(state, type, 3);
  LuaMachine::Of(state).Charge(SizeOf(event) / 16);
  const bool fits = events.waiting_bytes() + SizeOf(event) <= limits.event_bytes;
  if (fits) events.Add(std::move(event));
  if (!fits) return RaiseFull(state);
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
  if (target->kind == ValueKind::kAgent) AgentArgument(state, 2);
  LuaMachine& machine = LuaMachine::Of(state);
  CheckCallbacks(state);
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
  CheckCallbacks(state);
  lua_pushvalue(state, 3);
  ContextOf(state).collisions.Add(object->id(), machine, luaL_ref(state, LUA_REGISTRYINDEX));
  return 0;
}

int End(lua_State* state) {
  const std::string_view end = TextArgument(state, 2);
  if (SandboxArgument(state, 1)) ContextOf(state).reporter.EndReached(end);
  return 0;
}

/// Reads a file on the scripts' search path with its restrictions: only the scenario's folder and the library.
int ReadText(lua_State* state) {
  const std::string_view name = TextArgument(state, 2);
  if (!SandboxArgument(state, 1)) return 0;
  LuaMachine& machine = LuaMachine::Of(state);
  const Result<const ScriptSource*> source = machine.path().Load(name);
  if (!source.ok()) {
    const Diagnostic& error = source.error();
    lua_pushfstring(state, "%s%s%s", error.message.c_str(), error.hint.empty() ? "" : ": ", error.hint.c_str());
  } else {
    machine.Charge(source.value()->content.size() / 16);
    lua_pushlstring(state, source.value()->content.data(), source.value()->content.size());
  }
  return source.ok() ? 1 : -1;
}

/// A separate function, so that no C++ string is alive when the error is raised.
int ReadTextOrRaise(lua_State* state) {
  const int count = ReadText(state);
  return count < 0 ? lua_error(state) : count;
}

constexpr Binding kSandboxEventsBindings[] = {
    {"AddCollisionCallback", AddCollisionCallback, 3, 3, WrongCount::kIgnored},
    {"AddEvent", AddEvent, 3, 3, WrongCount::kError},
    {"AddEventCallback", AddEventCallback, 3, 3, WrongCount::kError},
    {"End", End, 2, 2, WrongCount::kError},
    {"ReadText", ReadTextOrRaise, 2, 2, WrongCount::kError},
};

}  // namespace

void BindSandboxEvents(lua_State* state) {
  RegisterTable(state, "Sandbox", kSandboxEventsBindings);
}

}  // namespace soarbox::script
