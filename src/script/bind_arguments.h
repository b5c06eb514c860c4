// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "script/lua_values.h"
#include "script/script_context.h"

namespace soarbox::script {

/// Arguments of the sandbox's API. Unless stated otherwise, a wrong type and a handle of a removed thing raise a Lua
/// error. "Refused" means: returns null, none or false, after a warning that the call is ignored.

/// True if the argument is the sandbox; else refused.
bool SandboxArgument(lua_State* state, int index);
world::Agent& AgentArgument(lua_State* state, int index);
/// An object; other values are refused.
world::Object* ObjectArgument(lua_State* state, int index);
/// The scene node of the sandbox, of an object, of a node or (if allowed) of an agent; other values are refused.
world::NodeId NodeArgument(lua_State* state, int index, bool agents_too);
world::UiId UiArgument(lua_State* state, int index);
/// The scene node of a body with a skeleton. Raises for a node without a skeleton; a value without a node is refused.
world::NodeId BodyArgument(lua_State* state, int index);
std::string_view TextArgument(lua_State* state, int index);
/// Lua's truth: everything but nil and false.
bool TruthArgument(lua_State* state, int index);
/// The vectors in a table, in its order. Other values, and vectors that are not finite, are skipped with a warning.
std::vector<world::Vec3> VectorsArgument(lua_State* state, int index);

/// Warns if the world refused a value; for the results of setters.
void WarnUnless(lua_State* state, bool accepted);
/// Warns if a capsule would be shorter than its caps.
void WarnOfShortCapsule(lua_State* state, float height, float radius);
/// The kinds of things that scripts create, for ChargeForCreation.
enum class Made : unsigned char { kNode, kLight, kObject, kAgent, kPanel, kOther };
/// Charges the script's budget for creating a thing, so that an endless loop cannot fill the world. Raises a Lua error
/// if the maximum number of these things exists (WorldLimits).
void ChargeForCreation(lua_State* state, Made made);
/// Raises a Lua error if `count` reaches `most`. `things` names them in the message: "objects".
void CheckRoom(lua_State* state, std::size_t count, std::size_t most, const char* things);
/// Pushes {x=, y=}.
void PushPoint(lua_State* state, float x, float y);

}  // namespace soarbox::script
