// SPDX-License-Identifier: BSD-2-Clause
#include <string>

#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

/// The upper limit in the arguments; 0 if there is none. Returns false, after an error message, if it is not a number.
bool LimitOf(FunctionContext& context, Arguments arguments, const char* function, double& limit) {
  if (arguments.empty()) {
    limit = 0;
    return true;
  }
  if (!arguments[0].IsNumber()) {
    context.PrintError("Error: non-number (" + ToString(context.symbols(), arguments[0]) + ") passed to - " + function +
                       "\n");
    return false;
  }
  limit = context.symbols().NumberValue(arguments[0]);
  return true;
}

}  // namespace

// Limits above 32 bits lose their upper bits, as in Soar.
Symbol RandomInteger(FunctionContext& context, Arguments arguments) {
  double limit = 0;
  if (!LimitOf(context, arguments, "rand-int", limit)) {
    return {};
  }
  constexpr double kTooLarge = 9223372036854775808.0;
  if (!(limit >= 1) || limit >= kTooLarge) {
    return context.symbols().Integer(context.random().Next32());
  }
  const std::int64_t highest =
      arguments[0].IsInteger() ? context.symbols().IntegerValue(arguments[0]) : static_cast<std::int64_t>(limit);
  return context.symbols().Integer(context.random().Integer(static_cast<std::uint32_t>(highest)));
}

Symbol RandomFloat(FunctionContext& context, Arguments arguments) {
  double limit = 0;
  if (!LimitOf(context, arguments, "rand-float", limit)) {
    return {};
  }
  return context.symbols().Float(limit > 0 ? context.random().Real(limit) : context.random().Real());
}

}  // namespace soarbox::kernel::function_bodies
