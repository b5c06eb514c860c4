// SPDX-License-Identifier: BSD-2-Clause
#include <cmath>
#include <limits>
#include <string>

#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

/// The multiple of `unit` nearest to `value`; half is rounded away from zero. A negative unit truncates, as in Soar.
std::int64_t NearestMultiple(std::int64_t value, std::int64_t unit) {
  if (unit == -1) {
    return value;
  }
  const std::int64_t rest = value % unit, cut = value - rest;
  // Comparing the remainder with the distance to the next multiple avoids the overflow of doubling it.
  const std::int64_t size = rest < 0 ? -rest : rest;
  if (unit < 0 || size == 0 || size < unit - size) {
    return cut;
  }
  const bool fits = value < 0 ? cut >= std::numeric_limits<std::int64_t>::min() + unit
                              : cut <= std::numeric_limits<std::int64_t>::max() - unit;
  return !fits ? cut : value < 0 ? cut - unit : cut + unit;
}

double NearestMultiple(double value, double unit) {
  const double rest = std::fmod(value, unit), cut = value - rest;
  if (unit < 0 || 2 * std::fabs(rest) < unit) {
    return cut;
  }
  return value < 0 ? cut - unit : cut + unit;
}

/// A heading in degrees, normalized to more than -180 and at most 180.
std::int64_t WithinHalfTurns(std::int64_t heading) {
  heading %= 360;
  return heading > 180 ? heading - 360 : heading <= -180 ? heading + 360 : heading;
}

double WithinHalfTurns(double heading) {
  heading = std::fmod(heading, 360.0);
  return heading > 180 ? heading - 360 : heading <= -180 ? heading + 360 : heading;
}

/// Truncates towards zero. Values out of range become the nearest integer in range.
std::int64_t Whole(const SymbolTable& symbols, Symbol number) {
  if (number.IsInteger()) {
    return symbols.IntegerValue(number);
  }
  constexpr double kLimit = 9223372036854775808.0;
  const double value = symbols.FloatValue(number);
  if (value >= kLimit) {
    return std::numeric_limits<std::int64_t>::max();
  }
  return value >= -kLimit ? static_cast<std::int64_t>(value) : std::numeric_limits<std::int64_t>::min();
}

/// The unit determines the type: an integer gives integers; a float gives floats, which are rounded to tenths. As in
/// Soar, a value that is not a number counts as 0.
Symbol Rounded(FunctionContext& context, Arguments arguments, const char* function, bool heading) {
  if (arguments.size() != 2) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  const Symbol unit = arguments[1];
  const Symbol number = arguments[0].IsNumber() ? arguments[0] : symbols.Integer(0);
  if (!unit.IsNumber()) {
    context.PrintError("Error: non-number (" + ToString(symbols, unit) + ") passed to - " + function + "\n");
    return {};
  }
  const double unit_tenths = unit.IsFloat() ? std::trunc(symbols.FloatValue(unit) * 10.0) : 10.0;
  if (unit_tenths == 0 || (unit.IsInteger() && symbols.IntegerValue(unit) == 0)) {
    context.PrintError("Error: attempt to divide ('" + std::string(function) + "') by zero.\n");
    return {};
  }
  if (unit.IsInteger()) {
    const std::int64_t result = NearestMultiple(Whole(symbols, number), symbols.IntegerValue(unit));
    return symbols.Integer(heading ? WithinHalfTurns(result) : result);
  }
  const double result = NearestMultiple(std::trunc(symbols.NumberValue(number) * 10.0), unit_tenths) / 10.0;
  return symbols.Float(heading ? WithinHalfTurns(result) : result);
}

}  // namespace

Symbol RoundOff(FunctionContext& context, Arguments arguments) {
  return Rounded(context, arguments, "round-off", false);
}

Symbol RoundOffHeading(FunctionContext& context, Arguments arguments) {
  return Rounded(context, arguments, "round-off-heading", true);
}

}  // namespace soarbox::kernel::function_bodies
