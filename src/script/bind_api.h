// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;

namespace soarbox::script {

/// The tables of the sandbox's API (docs/spec/lua_api.md, 5). Each function registers one table or a part of one.
void BindCoreCreate(lua_State* state);
void BindCoreScene(lua_State* state);
void BindCorePhysics(lua_State* state);
void BindCoreDraw(lua_State* state);
void BindSandboxCreate(lua_State* state);
void BindSandboxView(lua_State* state);
void BindSandboxEvents(lua_State* state);
void BindSandboxInfluence(lua_State* state);
void BindSandboxNavigation(lua_State* state);
void BindAgentProperties(lua_State* state);
void BindAgentShow(lua_State* state);
void BindAgentSteering(lua_State* state);
void BindAgentStride(lua_State* state);
void BindAnimation(lua_State* state);
void BindAnimationBones(lua_State* state);
void BindSandboxSound(lua_State* state);
void BindUi(lua_State* state);
void BindUiParts(lua_State* state);

/// The machine that the API is for: only the sandbox's own has the table UI.
enum class ApiSide { kSandbox, kAgent };

/// Registers all of the above, Vector, and the metatables. Call it inside a protected call, in a machine with a
/// context.
void BindApi(lua_State* state, ApiSide side);

}  // namespace soarbox::script
