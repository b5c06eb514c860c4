// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "script/lua_values.h"
#include "script/script_context.h"

namespace soarbox::script {

// Arguments of the sandbox's API. CheckArguments has checked their types before, so wrong types are errors here. A
// handle of a removed thing raises a Lua error.

world::Agent& AgentArgument(lua_State* state, int index);
world::Object& ObjectArgument(lua_State* state, int index);
/// The scene node of a node, an object, an agent or the sandbox.
world::NodeId NodeArgument(lua_State* state, int index);
world::UiId UiArgument(lua_State* state, int index);
/// A mesh with a skeleton, and its animator.
struct Body {
  world::NodeId node;
  world::Animator& animator;
};
/// Raises for an agent and for a node without a skeleton.
Body BodyArgument(lua_State* state, int index);
/// Raises if the mesh of the animation was removed.
world::Scene::FoundAnimation AnimationArgument(lua_State* state, int index);
std::string_view TextArgument(lua_State* state, int index);
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
