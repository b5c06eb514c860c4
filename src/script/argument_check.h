// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "script/binding.h"

struct lua_State;

namespace soarbox::script {

/// Checks all arguments on the stack. The first wrong one is a Lua error, or a warning and the result false if its type
/// only makes the call do nothing. Replaces numbers and vectors out of range by the nearest valid value, with a
/// warning. In a call without results, a value that is not finite makes the call do nothing.
bool CheckArguments(lua_State* state, const Binding& binding);

/// Like luaL_argerror, but also names functions of the API whose names Lua does not know (for example when pcall calls
/// them).
int ArgumentError(lua_State* state, int index, const char* text);

/// Makes it an error to read an unknown name from a table of the API if it is near a known one. Other unknown names
/// still give nil. The table is on top of the stack and stays there.
void GuardNames(lua_State* state, const char* table);

/// Raises the error for such a name. Returns if no known name is near.
void RaiseIfNear(lua_State* state, std::string_view table, std::string_view name);

}  // namespace soarbox::script
