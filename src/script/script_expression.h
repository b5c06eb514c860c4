// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>

struct lua_State;

namespace soarbox::script {

/// Pushes the variable with this name and returns true; returns false and pushes nothing if there is none.
using PushVariable = std::function<bool(lua_State* state, const std::string& name)>;

/// Evaluates an expression of Lua without running code of scripts, and pushes its value. It may contain variables,
/// fields, indices, calls of built-in functions and methods, operators, strings and numbers, but no table constructors
/// and functions. Raises a Lua error if the expression is wrong, fails, or needs a function of a script. Call it inside
/// a protected call.
void EvaluateExpression(lua_State* state, std::string_view expression, const PushVariable& variable);

}  // namespace soarbox::script
