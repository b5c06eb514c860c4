// SPDX-License-Identifier: BSD-2-Clause
#include "script/bind_api.h"

#include <lua.hpp>

#include "script/api_table.h"
#include "script/binding.h"
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
  for (const ApiGroup& group : ApiGroups())
    if (group.name != "UI" || side == ApiSide::kSandbox) RegisterTable(state, group);
  KeepAgentMethods(state);

  const char* kind = side == ApiSide::kSandbox ? "Sandbox" : "Agent";
  lua_pushfstring(state, "AI %s VM - \"%s\"", kind, LuaMachine::Of(state).script().c_str());
  lua_setglobal(state, "decoda_name");
}

}  // namespace soarbox::script
