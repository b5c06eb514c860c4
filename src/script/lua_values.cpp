// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_values.h"

#include <lua.hpp>
#include <new>

#include "script/bind_vector.h"
#include "script/lua_machine.h"

namespace soarbox::script {
namespace {

/// Metatables by kind; Sandbox, SandboxObject and SceneNode share one, told apart by the kind.
const char* MetatableOf(ValueKind kind) {
  switch (kind) {
    case ValueKind::kVector:
      return "Vector3Type";
    case ValueKind::kAgent:
      return "AgentType";
    case ValueKind::kUi:
      return "UIComponentType";
    default:
      return "LuaScriptType";
  }
}

// Registry keys of the metatables by kind, and of the agent handles that were pushed before: addresses are faster to
// look up than names.
char metatable_keys[6];
char agent_handles_key;

void PushMetatable(lua_State* state, ValueKind kind) {
  lua_pushlightuserdata(state, &metatable_keys[static_cast<std::size_t>(kind)]);
  lua_rawget(state, LUA_REGISTRYINDEX);
}

/// Files the metatable on top of the stack for its kind, and pops it.
void KeepMetatable(lua_State* state, ValueKind kind) {
  lua_pushlightuserdata(state, &metatable_keys[static_cast<std::size_t>(kind)]);
  lua_insert(state, -2);
  lua_rawset(state, LUA_REGISTRYINDEX);
}

int HandlesAreEqual(lua_State* state) {
  const Handle* a = ToHandle(state, 1);
  const Handle* b = ToHandle(state, 2);
  lua_pushboolean(state, a && b && a->kind == b->kind && a->number == b->number);
  return 1;
}

/// agent:Name() looks in the functions of the API alone, not in what scripts add to the table Agent.
int IndexAgent(lua_State* state) {
  std::size_t length = 0;
  const char* key = lua_tolstring(state, 2, &length);
  if (!key) return 0;
  lua_getfield(state, LUA_REGISTRYINDEX, "soarbox.agent_methods");
  lua_pushlstring(state, key, length);
  lua_rawget(state, -2);
  return 1;
}

void InstallHandleMetatable(lua_State* state, ValueKind kind) {
  if (luaL_newmetatable(state, MetatableOf(kind)) != 0) {
    lua_pushcfunction(state, HandlesAreEqual);
    lua_setfield(state, -2, "__eq");
    if (kind == ValueKind::kAgent) {
      lua_pushcfunction(state, IndexAgent);
      lua_setfield(state, -2, "__index");
    }
    lua_pushstring(state, MetatableOf(kind));
    lua_setfield(state, -2, "__metatable");
  }
  KeepMetatable(state, kind);
}

/// Agents never go, so one handle for each serves: scripts ask for all agents in every step.
bool PushKnownAgent(lua_State* state, std::uint32_t number) {
  lua_pushlightuserdata(state, &agent_handles_key);
  lua_rawget(state, LUA_REGISTRYINDEX);
  lua_rawgeti(state, -1, static_cast<int>(number));
  lua_remove(state, -2);
  if (!lua_isnil(state, -1)) return true;
  lua_pop(state, 1);
  return false;
}

void KeepAgent(lua_State* state, std::uint32_t number) {
  lua_pushlightuserdata(state, &agent_handles_key);
  lua_rawget(state, LUA_REGISTRYINDEX);
  lua_pushvalue(state, -2);
  lua_rawseti(state, -2, static_cast<int>(number));
  lua_pop(state, 1);
}

}  // namespace

void InstallValues(lua_State* state) {
  luaL_newmetatable(state, MetatableOf(ValueKind::kVector));
  InstallVectorMetamethods(state);
  KeepMetatable(state, ValueKind::kVector);
  for (const ValueKind kind :
       {ValueKind::kAgent, ValueKind::kSandbox, ValueKind::kObject, ValueKind::kNode, ValueKind::kUi})
    InstallHandleMetatable(state, kind);
  lua_pushlightuserdata(state, &agent_handles_key);
  lua_newtable(state);
  lua_rawset(state, LUA_REGISTRYINDEX);
}

void PushVector(lua_State* state, world::Vec3 vector) {
  new (lua_newuserdata(state, sizeof(VectorValue))) VectorValue{ValueKind::kVector, vector};
  PushMetatable(state, ValueKind::kVector);
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
  LuaMachine::Of(state).Charge(ids.size());
  lua_createtable(state, static_cast<int>(ids.size()), 0);
  lua_pushlightuserdata(state, &agent_handles_key);
  lua_rawget(state, LUA_REGISTRYINDEX);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    lua_rawgeti(state, -1, static_cast<int>(Number(ids[i])));
    if (lua_isnil(state, -1)) {
      lua_pop(state, 1);
      PushAgent(state, ids[i]);
    }
    lua_rawseti(state, -3, static_cast<int>(i + 1));
  }
  lua_pop(state, 1);
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
  luaL_argerror(state, index,
                lua_pushfstring(state, "%s expected, got %s", NameOf(ValueKind::kVector), NameOfValue(state, index)));
  return {};
}

std::uint32_t CheckHandle(lua_State* state, int index, ValueKind kind) {
  const Handle* handle = ToHandle(state, index);
  if (handle && handle->kind == kind) return handle->number;
  luaL_argerror(state, index, lua_pushfstring(state, "%s expected, got %s", NameOf(kind), NameOfValue(state, index)));
  return 0;
}

float CheckFloat(lua_State* state, int index) {
  return static_cast<float>(luaL_checknumber(state, index));
}

const char* NameOf(ValueKind kind) {
  switch (kind) {
    case ValueKind::kVector:
      return "Vector3Type";
    case ValueKind::kAgent:
      return "AgentType";
    case ValueKind::kSandbox:
      return "sandbox";
    case ValueKind::kObject:
      return "sandbox object";
    case ValueKind::kNode:
      return "scene node";
    case ValueKind::kUi:
      return "UI component";
  }
  return "userdata";
}

const char* NameOfValue(lua_State* state, int index) {
  if (const auto* kind = static_cast<const ValueKind*>(lua_touserdata(state, index))) return NameOf(*kind);
  return luaL_typename(state, index);
}

}  // namespace soarbox::script
