// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_function_names.h"

#include <lua.hpp>

namespace soarbox::script {

std::string NameOfGlobalFunction(lua_State* state, const lua_Debug& call) {
  lua_Debug info = call;
  const int top = lua_gettop(state);
  if (lua_checkstack(state, 6) == 0 || lua_getinfo(state, "fS", &info) == 0) return "a function";
  const int function = lua_gettop(state);
  std::string name;
  lua_pushnil(state);
  while (lua_next(state, LUA_GLOBALSINDEX) != 0) {
    if (lua_type(state, -2) == LUA_TSTRING && lua_rawequal(state, -1, function) != 0) {
      // If there are several names, the first in alphabetical order, because the order of the table may differ.
      const std::string found = lua_tostring(state, -2);
      if (name.empty() || found < name) name = found;
    }
    lua_pop(state, 1);
  }
  lua_settop(state, top);
  return name.empty() ? "the function at line " + std::to_string(info.linedefined) : name;
}

}  // namespace soarbox::script
