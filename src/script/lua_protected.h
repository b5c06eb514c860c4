// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <lua.hpp>
#include <optional>
#include <string>

namespace soarbox::script {

/// Runs body(lua_State*) in its own protected call on this state, also inside a hook. Returns the message of its error,
/// if it failed.
template <class Body>
std::optional<std::string> Guarded(lua_State* state, Body body) {
  const auto run = [](lua_State* inner) {
    Body& wanted = *static_cast<Body*>(lua_touserdata(inner, 1));
    luaL_checkstack(inner, 40, "too many nested calls");
    wanted(inner);
    return 0;
  };
  const int top = lua_gettop(state);
  std::optional<std::string> failed;
  if (lua_cpcall(state, run, &body) != 0) {
    const char* message = lua_tostring(state, -1);
    failed = message == nullptr ? "an error that is not a string" : message;
  }
  lua_settop(state, top);
  return failed;
}

}  // namespace soarbox::script
