// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_values.h"

#include <lua.hpp>
#include <new>

#include "diagnostics/name_table.h"
#include "script/argument_check.h"
#include "script/bind_vector.h"
#include "script/lua_machine.h"

namespace soarbox::script {
namespace {

/// Metatables by kind. kSandbox, kObject and kNode share one; code distinguishes them by their kind.
const char* MetatableOf(ValueKind kind) {
  switch (kind) {
    case ValueKind::kVector:
      return "Vector3Type";
    case ValueKind::kAgent:
      return "AgentType";
    case ValueKind::kUi:
      return "UIComponentType";
    case ValueKind::kAnimation:
      return "AnimationType";
    default:
      return "LuaScriptType";
  }
}

void PushMetatable(lua_State* state, ValueKind kind) {
  lua_rawgeti(state, LUA_REGISTRYINDEX, LuaMachine::Of(state).values.metatables[static_cast<std::size_t>(kind)]);
}

/// Stores the metatable on top of the stack for its kind, and pops it.
void KeepMetatable(lua_State* state, ValueKind kind) {
  LuaMachine::Of(state).values.metatables[static_cast<std::size_t>(kind)] = luaL_ref(state, LUA_REGISTRYINDEX);
}

void PushAgentHandles(lua_State* state) {
  lua_rawgeti(state, LUA_REGISTRYINDEX, LuaMachine::Of(state).values.agent_handles);
}

int HandlesAreEqual(lua_State* state) {
  const Handle* a = ToHandle(state, 1);
  const Handle* b = ToHandle(state, 2);
  lua_pushboolean(state, a && b && a->kind == b->kind && a->number == b->number);
  return 1;
}

/// agent:Name() without such a function: an error if there is one with a similar name.
int IndexUnknownMethod(lua_State* state) {
  std::size_t length = 0;
  if (lua_type(state, 2) != LUA_TSTRING) return 0;
  const char* key = lua_tolstring(state, 2, &length);
  RaiseIfNear(state, "Agent", {key, length});
  return 0;
}

void InstallHandleMetatable(lua_State* state, ValueKind kind) {
  if (luaL_newmetatable(state, MetatableOf(kind)) != 0) {
    lua_pushcfunction(state, HandlesAreEqual);
    lua_setfield(state, -2, "__eq");
    lua_pushstring(state, MetatableOf(kind));
    lua_setfield(state, -2, "__metatable");
  }
  KeepMetatable(state, kind);
}

/// Pushes the handle of this agent if the machine already has one. Ids of agents are never reused, so one handle per
/// agent is enough. Scripts request all agents in each step.
bool PushKnownAgent(lua_State* state, std::uint32_t number) {
  const LuaMachine& machine = LuaMachine::Of(state);
  if (number == machine.owner() && machine.values.own_handle != 0) {
    lua_rawgeti(state, LUA_REGISTRYINDEX, machine.values.own_handle);
    return true;
  }
  PushAgentHandles(state);
  lua_rawgeti(state, -1, static_cast<int>(number));
  lua_remove(state, -2);
  if (!lua_isnil(state, -1)) return true;
  lua_pop(state, 1);
  return false;
}

void KeepAgent(lua_State* state, std::uint32_t number) {
  LuaMachine& machine = LuaMachine::Of(state);
  if (number == machine.owner()) {
    lua_pushvalue(state, -1);
    machine.values.own_handle = luaL_ref(state, LUA_REGISTRYINDEX);
  }
  PushAgentHandles(state);
  lua_pushvalue(state, -2);
  lua_rawseti(state, -2, static_cast<int>(number));
  lua_pop(state, 1);
}

}  // namespace

void InstallValues(lua_State* state) {
  luaL_newmetatable(state, MetatableOf(ValueKind::kVector));
  InstallVectorMetamethods(state);
  KeepMetatable(state, ValueKind::kVector);
  for (const ValueKind kind : {ValueKind::kAgent, ValueKind::kSandbox, ValueKind::kObject, ValueKind::kNode,
                               ValueKind::kUi, ValueKind::kAnimation})
    InstallHandleMetatable(state, kind);
  lua_newtable(state);
  LuaMachine::Of(state).values.agent_handles = luaL_ref(state, LUA_REGISTRYINDEX);
}

void InstallAgentMethods(lua_State* state) {
  lua_newtable(state);
  lua_pushcfunction(state, IndexUnknownMethod);
  lua_setfield(state, -2, "__index");
  lua_setmetatable(state, -2);
  PushMetatable(state, ValueKind::kAgent);
  lua_insert(state, -2);
  lua_setfield(state, -2, "__index");
  lua_pop(state, 1);
}

void PushVector(lua_State* state, world::Vec3 vector) {
  const LuaMachine& machine = LuaMachine::Of(state);
  new (lua_newuserdata(state, sizeof(VectorValue))) VectorValue{ValueKind::kVector, vector};
  lua_rawgeti(state, LUA_REGISTRYINDEX, machine.values.metatables[static_cast<std::size_t>(ValueKind::kVector)]);
  lua_setmetatable(state, -2);
}

void PushHandle(lua_State* state, Handle handle) {
  const bool is_agent = handle.kind == ValueKind::kAgent;
  if (is_agent && PushKnownAgent(state, handle.number)) return;
  new (lua_newuserdata(state, sizeof(Handle))) Handle(handle);
  PushMetatable(state, handle.kind);
  lua_setmetatable(state, -2);
  if (is_agent) KeepAgent(state, handle.number);
}

void PushAgents(lua_State* state, std::span<const world::EntityId> ids) {
  LuaMachine& machine = LuaMachine::Of(state);
  machine.Charge(ids.size());
  machine.agent_lists.Push(state, ids);
}

world::Vec3* ToVector(lua_State* state, int index) {
  auto* value = static_cast<VectorValue*>(lua_touserdata(state, index));
  return value && value->kind == ValueKind::kVector ? &value->vector : nullptr;
}

const Handle* ToHandle(lua_State* state, int index) {
  const auto* handle = static_cast<const Handle*>(lua_touserdata(state, index));
  return handle && handle->kind != ValueKind::kVector ? handle : nullptr;
}

world::Vec3 CheckVector(lua_State* state, int index) {
  if (const world::Vec3* vector = ToVector(state, index)) return *vector;
  ArgumentError(state, index,
                lua_pushfstring(state, "%s expected, got %s", NameOf(ValueKind::kVector), NameOfValue(state, index)));
  return {};
}

std::uint32_t CheckHandle(lua_State* state, int index, ValueKind kind) {
  const Handle* handle = ToHandle(state, index);
  if (handle && handle->kind == kind) return handle->number;
  ArgumentError(state, index, lua_pushfstring(state, "%s expected, got %s", NameOf(kind), NameOfValue(state, index)));
  return 0;
}

float CheckFloat(lua_State* state, int index) {
  const double number = lua_tonumber(state, index);
  // Other values than numbers give 0.
  if (number == 0 && !lua_isnumber(state, index))
    ArgumentError(state, index, lua_pushfstring(state, "number expected, got %s", NameOfValue(state, index)));
  return static_cast<float>(number);
}

const char* NameOf(ValueKind kind) {
  static constexpr const char* kNames[] = {"Vector3Type", "AgentType",    "sandbox",  "sandbox object",
                                           "scene node",  "UI component", "animation"};
  return NameIn(kNames, kind);
}

const char* NameOfValue(lua_State* state, int index) {
  if (const auto* kind = static_cast<const ValueKind*>(lua_touserdata(state, index))) return NameOf(*kind);
  return luaL_typename(state, index);
}

}  // namespace soarbox::script
