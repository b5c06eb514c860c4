// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "kernel/rules/functions/function_context.h"

namespace soarbox::kernel {

/// A function that is part of the kernel.
struct BuiltinFunction {
  std::string_view name;
  int arguments = -1;       ///< The number of arguments; -1 for any number.
  bool as_value = true;     ///< May be used where a value is expected.
  bool as_action = false;   ///< May be used alone, as an action.
  bool literalizes = true;  ///< Learning keeps the values of its arguments instead of converting them to variables.
  /// Returns the value, or the none symbol if there is none (after printing the reason). Never throws or crashes,
  /// whatever the number and kinds of the arguments.
  Symbol (*evaluate)(FunctionContext& context, std::span<const Symbol> arguments) = nullptr;
};

/// All built-in functions; RhsValue::function_index is an index into this list.
std::span<const BuiltinFunction> BuiltinFunctions();

/// The index of a built-in function, or RhsValue::kUserFunction.
std::uint16_t FindBuiltinFunction(std::string_view name);

/// The built-in function that is probably meant by an unknown name: `write` for `print` and other printing functions,
/// "rand-int or rand-float" for `random`, otherwise one with similar spelling. Empty if there is none.
std::string_view NearestFunction(std::string_view name);

/// Calls the function with this `function_index` (RhsValue), which must be a built-in one.
Symbol Evaluate(FunctionContext& context, std::uint16_t function_index, std::span<const Symbol> arguments);

}  // namespace soarbox::kernel
