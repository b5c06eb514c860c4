// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "world/ids.h"
#include "world/math.h"

struct lua_State;

namespace soarbox::script {

/// What a userdata of the sandbox's API is. Scripts can make no other userdata, so each one starts with this.
enum class ValueKind : std::uint32_t { kVector, kAgent, kSandbox, kObject, kNode, kUi, kAnimation };

/// A thin pointer into the world: two are equal if they mean the same thing, though they need not be the same userdata.
/// It keeps nothing alive.
struct Handle {
  ValueKind kind;
  std::uint32_t number;  ///< An EntityId, NodeId, UiId or AnimationId, as the kind says.
};

/// A vector as scripts hold it: a mutable object of its own.
struct VectorValue {
  ValueKind kind = ValueKind::kVector;
  world::Vec3 vector;
};

/// Registers the metatables of all kinds. Call inside a protected call, before any of the functions below.
void InstallValues(lua_State* state);

/// Makes the functions of the table on top of the stack what agent:Name() finds, and pops it: the table itself, so that
/// no function of ours runs for each call.
void InstallAgentMethods(lua_State* state);

void PushVector(lua_State* state, world::Vec3 vector);
void PushHandle(lua_State* state, Handle handle);
inline void PushAgent(lua_State* state, world::EntityId id) {
  PushHandle(state, {ValueKind::kAgent, Number(id)});
}
/// Pushes a new array of these agents' handles; faster than one by one.
void PushAgents(lua_State* state, std::span<const world::EntityId> ids);
inline void PushObject(lua_State* state, world::EntityId id) {
  PushHandle(state, {ValueKind::kObject, Number(id)});
}
inline void PushSandbox(lua_State* state) {
  PushHandle(state, {ValueKind::kSandbox, 0});
}
inline void PushNode(lua_State* state, world::NodeId id) {
  PushHandle(state, {ValueKind::kNode, Number(id)});
}

/// The vector at `index`; null for everything else.
world::Vec3* ToVector(lua_State* state, int index);
/// The handle at `index`; null for vectors and everything that is no userdata.
const Handle* ToHandle(lua_State* state, int index);

/// The vector at `index`, or a Lua error that names what is there instead.
world::Vec3 CheckVector(lua_State* state, int index);
/// A handle of that kind at `index`, or a Lua error.
std::uint32_t CheckHandle(lua_State* state, int index, ValueKind kind);
/// A number as the world's single-precision float.
float CheckFloat(lua_State* state, int index);

/// The name of a kind as error messages show it: "Vector3Type", "AgentType", ...
const char* NameOf(ValueKind kind);
/// What the value at `index` is, for messages: "AgentType", "nil", "number", ...
const char* NameOfValue(lua_State* state, int index);

}  // namespace soarbox::script
