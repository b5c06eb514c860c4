// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "script/api_table.h"

struct lua_State;

namespace soarbox::script {

/// What a call of one function must satisfy; made once for each function.
struct CheckedCall {
  std::vector<ApiArgument> arguments;  ///< As ParseArguments reads them from the table.
  bool takes_any_number = false;       ///< It only calculates: what is not finite goes in and comes out.
  bool gives_result = false;
};
const CheckedCall& CheckedCallOf(const ApiFunction& function);

/// Checks the arguments on the stack from the first to the last. The first that is wrong is a Lua error; if it is one
/// of those that only make a call do nothing, it is a warning, and the answer is false. Replaces numbers and vectors
/// out of range by the nearest in range, with a warning; what is not finite makes a call without results do nothing.
bool CheckArguments(lua_State* state, const CheckedCall& call);

/// Like luaL_argerror, but names functions of the API correctly even where Lua does not know their names (called by
/// pcall, for example).
int ArgumentError(lua_State* state, int index, const char* text);

/// Makes it an error to read a name that a table of the API does not have, if it is near one that it has; other names
/// still give nil. The table is on top of the stack and stays there.
void GuardNames(lua_State* state, const char* table);

/// Raises the error for such a name; returns if none is near.
void RaiseIfNear(lua_State* state, std::string_view table, std::string_view name);

}  // namespace soarbox::script
