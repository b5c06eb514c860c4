// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>

#include "script/api_call.h"
#include "script/lua_machine.h"
#include "script/script_path.h"

// Sandbox: custom events and collision callbacks (lua_api.md 4.3, 4.4).

namespace soarbox::script {
namespace {

using enum WrongCount;

/// A separate function, so that no C++ string is alive when the error is raised.
int RaiseFull(lua_State* state) {
  return luaL_error(state, "the waiting events of this world already hold %d MB: no more are accepted",
                    static_cast<int>(ContextOf(state).budget.limits().event_bytes >> 20));
}

void CheckCallbacks(lua_State* state) {
  const ScriptContext& context = ContextOf(state);
  CheckRoom(state, context.listeners.size() + context.collisions.size(), context.budget.limits().callbacks,
            "callbacks");
}

int AddEvent(lua_State* state) {
  const std::string_view type = TextArgument(state, 2);
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
  const Handle* target = ToHandle(state, 2);
  const bool can_hear = target && (target->kind == ValueKind::kAgent || target->kind == ValueKind::kObject ||
                                   target->kind == ValueKind::kSandbox);
  if (!can_hear) {
    WarnIgnored(state, "argument 2 is not an agent, an object or the sandbox");
    return 0;
  }
  if (target->kind == ValueKind::kObject) ObjectArgument(state, 2);
  if (target->kind == ValueKind::kAgent) AgentArgument(state, 2);
  CheckCallbacks(state);
  ContextOf(state).listeners.Set(*target, state, 3);
  return 0;
}

/// (sandbox, object, callback)
void AddCollisionCallback(lua_State* state, const world::World&, const world::Object& object) {
  CheckCallbacks(state);
  ContextOf(state).collisions.Add({ValueKind::kObject, Number(object.id())}, state, 3);
}

void End(lua_State* state, const world::World&, std::string_view end) {
  ContextOf(state).reporter.EndReached(end);
}

/// Reads a file on the scripts' search path with its restrictions: only the scenario's folder and the library.
int ReadText(lua_State* state) {
  const std::string_view name = TextArgument(state, 2);
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

constexpr ApiFunction kSandboxEventsFunctions[] = {
    {"Sandbox.AddCollisionCallback", kCall<AddCollisionCallback>, kIgnored,
     "sandbox: Sandbox, object: Object, callback: function", "",
     "Calls callback(sandbox, collision) after each step in which an agent or another body touches the object. The "
     "collision has the fields objectA (this object), objectB (the other object or agent), pointA, pointB and "
     "normalOnB.",
     R"(Sandbox.AddCollisionCallback(sandbox, object, function(sandbox, collision)
  Sandbox.RemoveObject(sandbox, collision.objectA)
end))"},
    {"Sandbox.AddEvent", AddEvent, kError, "sandbox: Sandbox, type: string, event: value", "",
     "Sends an event to all listeners at the beginning of the next step. The fields of the table may be numbers, "
     "strings, booleans, vectors, agents, objects and the sandbox; others are left out.",
     R"(Sandbox.AddEvent(sandbox, "Noise", {position = agent:GetPosition(), loudness = 3}))"},
    {"Sandbox.AddEventCallback", AddEventCallback, kError, "sandbox: Sandbox, listener: value, callback: function", "",
     "Adds a listener, which is an agent, an object or the sandbox: callback(sandbox, listener, type, event) is called "
     "for all events. A second callback of the same listener replaces the first.",
     R"(Sandbox.AddEventCallback(sandbox, agent, function(sandbox, agent, type, event)
  if type == "Noise" then agent:SetTarget(event.position) end
end))"},
    {"Sandbox.End", kCall<End>, kError, "sandbox: Sandbox, name: string", "",
     "Reports that the run has reached this end, like an [[end]] of a scenario file. A run without a window ends; "
     "otherwise the world and the scripts continue. Missions refer to the end by this name.",
     R"(Sandbox.End(sandbox, "all is eaten"))", true},
    {"Sandbox.ReadText", ReadTextOrRaise, kError, "sandbox: Sandbox, name: string", "string",
     "The content of a text file in the scenario's folder or the library's. A file that cannot be read is an error.",
     R"(local text = Sandbox.ReadText(sandbox, "Quiet.lua"))", true},
};

}  // namespace

std::span<const ApiFunction> SandboxEventsApi() {
  return kSandboxEventsFunctions;
}

}  // namespace soarbox::script
