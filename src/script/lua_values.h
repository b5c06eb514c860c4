// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "world/entity_ids.h"
#include "world/math.h"

struct lua_State;

namespace soarbox::script {

/// The kind of a userdata of the sandbox's API. Scripts cannot create other userdata, so each one starts with its kind.
enum class ValueKind : std::uint32_t { kVector, kAgent, kSandbox, kObject, kNode, kUi, kAnimation };

/// A reference to a thing of the world. Two handles are equal if they refer to the same thing, even if they are
/// different userdata. A handle keeps nothing alive.
struct Handle {
  ValueKind kind;
  std::uint32_t number;  ///< An EntityId, NodeId, UiId or AnimationId, depending on `kind`.
};

/// A vector of a script: a mutable object.
struct VectorValue {
  ValueKind kind = ValueKind::kVector;
  world::Vec3 vector;
};

/// Registers the metatables of all kinds. Call it inside a protected call, before any of the functions below.
void InstallValues(lua_State* state);

/// Makes agent:Name() find the functions of the table on top of the stack, and pops it. The table itself is the index,
/// so no function of ours runs for each call.
void InstallAgentMethods(lua_State* state);

void PushVector(lua_State* state, world::Vec3 vector);
void PushHandle(lua_State* state, Handle handle);
inline void PushAgent(lua_State* state, world::EntityId id) {
  PushHandle(state, {ValueKind::kAgent, Number(id)});
}
/// Pushes a new array of these agents' handles; faster than pushing them one by one.
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

/// Returns the vector at `index`; null for other values.
world::Vec3* ToVector(lua_State* state, int index);
/// Returns the handle at `index`; null for vectors and other values.
const Handle* ToHandle(lua_State* state, int index);

/// Returns the vector at `index`; raises a Lua error for other values.
world::Vec3 CheckVector(lua_State* state, int index);
/// Returns a handle of this kind at `index`; raises a Lua error for other values.
std::uint32_t CheckHandle(lua_State* state, int index, ValueKind kind);
/// Returns a number as the world's single-precision float.
float CheckFloat(lua_State* state, int index);

/// Returns the name of a kind for error messages: "Vector3Type", "AgentType", ...
const char* NameOf(ValueKind kind);
/// Returns the kind of the value at `index` for messages: "AgentType", "nil", "number", ...
const char* NameOfValue(lua_State* state, int index);

}  // namespace soarbox::script
