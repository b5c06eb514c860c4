// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>

struct lua_State;

namespace soarbox::script {

/// Pushes the variable of this name and returns true; false, and nothing pushed, if there is none.
using PushVariable = std::function<bool(lua_State* state, const std::string& name)>;

/// Evaluates an expression of Lua without running any code of scripts, and pushes its value: variables, fields,
/// indices, calls of built-in functions and methods, operators, texts and numbers. Tables and functions cannot be
/// written. Raises a Lua error if the expression is wrong, fails, or needs a function of a script. Call it inside a
/// protected call.
void EvaluateExpression(lua_State* state, std::string_view expression, const PushVariable& variable);

}  // namespace soarbox::script
