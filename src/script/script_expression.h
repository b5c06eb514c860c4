// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

struct lua_State;

namespace soarbox::script {

/// Pushes the variable with this name and returns true; returns false and pushes nothing if there is none.
using PushVariable = std::function<bool(lua_State* state, const std::string& name)>;

/// The calls that an expression may contain.
enum class MayCall : std::uint8_t {
  kBuiltIn,  ///< Of all built-in functions, also of those that change the world.
  kReading,  ///< Only of functions that change nothing: tostring, type, math.floor, ..., and functions whose names
             ///< begin with Get, Is or Has.
};

/// Evaluates an expression of Lua without running code of scripts, and pushes its value. It may contain variables,
/// fields, indices, calls of built-in functions and methods, operators, strings and numbers, but no table constructors
/// and functions. Raises a Lua error if the expression is wrong, fails, or needs a function of a script. Call it inside
/// a protected call.
void EvaluateExpression(lua_State* state, std::string_view expression, const PushVariable& variable,
                        MayCall may_call = MayCall::kBuiltIn);

}  // namespace soarbox::script
