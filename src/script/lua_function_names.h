// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

struct lua_State;
struct lua_Debug;

namespace soarbox::script {

/// Returns the name of the global variable that contains the called function, else "the function at line 12". Lua names
/// a function by the code that calls it, but the world calls functions by the names of global variables. Never raises.
std::string NameOfGlobalFunction(lua_State* state, const lua_Debug& call);

}  // namespace soarbox::script
