// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "script/lua_values.h"
#include "script/script_context.h"

namespace soarbox::script {

/// Arguments of the sandbox's API. Unless stated otherwise a wrong type raises a Lua error, and a handle of something
/// that was removed does too. "Refused" means: null, none or false, after a warning that the call is ignored.

/// True if the argument is the sandbox; else refused.
bool SandboxArgument(lua_State* state, int index);
world::Agent& AgentArgument(lua_State* state, int index);
/// An object; other values are refused.
world::Object* ObjectArgument(lua_State* state, int index);
/// The scene node of the sandbox, an object, a node or (if allowed) an agent; other values are refused.
world::NodeId NodeArgument(lua_State* state, int index, bool agents_too);
world::UiId UiArgument(lua_State* state, int index);
/// The scene node of a body with a skeleton; one without raises, what has no node at all is refused.
world::NodeId BodyArgument(lua_State* state, int index);
std::string_view TextArgument(lua_State* state, int index);
/// Lua's truth: everything but nil and false.
bool TruthArgument(lua_State* state, int index);
/// The vectors in a table, in its order; others, and those that are not finite, are skipped with a warning.
std::vector<world::Vec3> VectorsArgument(lua_State* state, int index);

/// Warns if the world refused a value; for the results of setters.
void WarnUnless(lua_State* state, bool accepted);
/// A capsule is at least as tall as its caps: warns where it was to be shorter.
void WarnOfShortCapsule(lua_State* state, float height, float radius);
/// What a script makes, for ChargeForCreation.
enum class Made : unsigned char { kNode, kLight, kObject, kAgent, kPanel, kOther };
/// Takes the price of making a thing off the script's budget, so that an endless loop cannot fill the world; a Lua
/// error if the world has as many as it may (WorldLimits).
void ChargeForCreation(lua_State* state, Made made);
/// A Lua error if `count` things ("objects") are there already and no more may be.
void CheckRoom(lua_State* state, std::size_t count, std::size_t most, const char* things);
/// Pushes {x=, y=}.
void PushPoint(lua_State* state, float x, float y);

}  // namespace soarbox::script
