// SPDX-License-Identifier: BSD-2-Clause
#include "script/bind_api.h"

#include <lua.hpp>

#include "script/bind_vector.h"
#include "script/lua_machine.h"
#include "script/lua_values.h"

namespace soarbox::script {
namespace {

/// Copies the current table Agent for agent:Name(), so that later additions of scripts to Agent do not count.
void KeepAgentMethods(lua_State* state) {
  lua_newtable(state);
  lua_getglobal(state, "Agent");
  lua_pushnil(state);
  while (lua_next(state, -2) != 0) {
    lua_pushvalue(state, -2);
    lua_insert(state, -2);
    lua_rawset(state, -5);
  }
  lua_pop(state, 1);
  InstallAgentMethods(state);
}

}  // namespace

void BindApi(lua_State* state, ApiSide side) {
  InstallValues(state);
  BindVector(state);
  BindCoreCreate(state);
  BindCoreScene(state);
  BindCorePhysics(state);
  BindCoreDraw(state);
  BindSandboxCreate(state);
  BindSandboxView(state);
  BindSandboxEvents(state);
  BindSandboxNavigation(state);
  BindSandboxInfluence(state);
  BindAgentProperties(state);
  BindAgentSteering(state);
  BindAgentShow(state);
  BindAgentStride(state);
  BindAnimation(state);
  BindAnimationBones(state);
  BindSandboxSound(state);
  if (side == ApiSide::kSandbox) {
    BindUi(state);
    BindUiParts(state);
  }
  KeepAgentMethods(state);

  const char* kind = side == ApiSide::kSandbox ? "Sandbox" : "Agent";
  lua_pushfstring(state, "AI %s VM - \"%s\"", kind, LuaMachine::Of(state).script().c_str());
  lua_setglobal(state, "decoda_name");
}

}  // namespace soarbox::script
