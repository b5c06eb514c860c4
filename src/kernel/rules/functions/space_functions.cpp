// SPDX-License-Identifier: BSD-2-Clause
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "kernel/base/words.h"
#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

/// Soar's value, a little smaller than the real one: the last degree of a heading depends on it.
constexpr double kPi = 3.1415926;

std::string Name(FunctionContext& context, Symbol symbol) { return ToString(context.symbols(), symbol); }

std::int64_t ToInt(double value) {
  constexpr double kLimit = 9223372036854775808.0;
  return value >= -kLimit && value < kLimit ? static_cast<std::int64_t>(value) : 0;
}

/// The multiple of `unit` nearest to `value`, half away from zero. `unit` must not be 0.
std::int64_t NearestMultiple(std::int64_t value, std::int64_t unit) {
  const double quotient = static_cast<double>(value) / static_cast<double>(unit);
  return ToInt(std::round(quotient) * static_cast<double>(unit));
}

template <typename Number>
Number WithinHalfTurns(Number heading, Number full) {
  heading = static_cast<Number>(std::fmod(static_cast<double>(heading), static_cast<double>(full)));
  const Number half = full / 2;
  return heading > half ? heading - full : heading < -half ? heading + full : heading;
}

Symbol Rounded(FunctionContext& context, Arguments arguments, const char* function, bool heading) {
  if (arguments.size() != 2) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  for (const Symbol argument : arguments) {
    if (!argument.IsNumber()) {
      context.PrintError("Error: non-number (" + Name(context, argument) + ") passed to - " + function + "\n");
      return {};
    }
  }
  // Floats are rounded in tenths.
  const bool tenths = arguments[1].IsFloat();
  const double scale = tenths ? 10.0 : 1.0;
  const std::int64_t value = ToInt(symbols.NumberValue(arguments[0]) * scale);
  const std::int64_t unit = ToInt(symbols.NumberValue(arguments[1]) * scale);
  if (unit == 0) {
    context.PrintError("Error: attempt to divide ('" + std::string(function) + "') by zero.\n");
    return {};
  }
  const std::int64_t result = NearestMultiple(value, unit);
  if (!tenths) {
    return symbols.Integer(heading ? WithinHalfTurns<std::int64_t>(result, 360) : result);
  }
  const double in_units = static_cast<double>(result) / 10.0;
  return symbols.Float(heading ? WithinHalfTurns(in_units, 360.0) : in_units);
}

/// The difference between two points as four numbers give them; false after saying what is not a number.
bool Difference(FunctionContext& context, Arguments arguments, const char* function, double& dx, double& dy) {
  for (const Symbol argument : arguments) {
    if (!argument.IsNumber()) {
      context.PrintError("Error: non-number (" + Name(context, argument) + ") passed to - " + function + "\n");
      return false;
    }
  }
  if (arguments.size() != 4) {
    return false;
  }
  const SymbolTable& symbols = context.symbols();
  dx = symbols.NumberValue(arguments[2]) - symbols.NumberValue(arguments[0]);
  dy = symbols.NumberValue(arguments[3]) - symbols.NumberValue(arguments[1]);
  return true;
}

bool FourIntegers(FunctionContext& context, Arguments arguments, const char* function, double (&out)[4]) {
  if (arguments.size() != 4) {
    return false;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (!arguments[i].IsInteger()) {
      context.PrintError("Error: non int(" + Name(context, arguments[i]) + ") passed to " + function + " function.\n");
      return false;
    }
    out[i] = static_cast<double>(context.symbols().IntegerValue(arguments[i]));
  }
  return true;
}

double BinomialProbability(std::int64_t trials, std::int64_t successes, double chance) {
  if (successes < 0 || successes > trials) {
    return 0;
  }
  const double n = static_cast<double>(trials), k = static_cast<double>(successes);
  if (chance >= 1) {
    return successes == trials ? 1 : 0;
  }
  double ways = 1;
  for (double i = 1; i <= k; ++i) {
    ways *= (n - k + i) / i;
    if (!std::isfinite(ways)) {
      break;
    }
  }
  return ways * std::pow(chance, k) * std::pow(1 - chance, n - k);
}

}  // namespace

Symbol RoundOff(FunctionContext& context, Arguments arguments) { return Rounded(context, arguments, "round-off", false); }
Symbol RoundOffHeading(FunctionContext& context, Arguments arguments) {
  return Rounded(context, arguments, "round-off-heading", true);
}

Symbol Heading(FunctionContext& context, Arguments arguments) {
  double dx = 0, dy = 0;
  if (!Difference(context, arguments, "compute-heading", dx, dy)) {
    return {};
  }
  double heading = 90.0 - std::atan2(dy, dx) * 180.0 / kPi;
  if (heading > 180.0) {
    heading -= 360.0;
  }
  return context.symbols().Integer(ToInt(heading));
}

Symbol Range(FunctionContext& context, Arguments arguments) {
  double dx = 0, dy = 0;
  if (!Difference(context, arguments, "compute-range", dx, dy)) {
    return {};
  }
  return context.symbols().Integer(ToInt(std::sqrt(dx * dx + dy * dy)));
}

// Position, heading in degrees, speed and time, as Soar takes them: the first number is the start in both directions.
Symbol PredictX(FunctionContext& context, Arguments arguments) {
  double in[4];
  if (!FourIntegers(context, arguments, "predict-x", in)) {
    return {};
  }
  return context.symbols().Integer(ToInt(std::round(in[0] + in[2] * in[3] * std::sin(in[1] * kPi / 180.0))));
}

Symbol PredictY(FunctionContext& context, Arguments arguments) {
  double in[4];
  if (!FourIntegers(context, arguments, "predict-y", in)) {
    return {};
  }
  return context.symbols().Integer(ToInt(std::round(in[0] - in[2] * in[3] * std::cos(in[1] * kPi / 180.0))));
}

/// x, y, heading in degrees, and an identifier whose values are points with ^x and ^y: gives the point that comes
/// nearest to the ray from (x, y) along the heading.
Symbol ClosestIntercept(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 4) {
    return {};
  }
  const SymbolTable& symbols = context.symbols();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!arguments[i].IsNumber()) {
      context.PrintError("Error: non int (" + Name(context, arguments[i]) + ") passed to compute-closest-intercept function.\n");
      return {};
    }
  }
  if (!arguments[3].IsIdentifier()) {
    context.PrintError("Error: non-symbol (" + Name(context, arguments[3]) +
                       ") passed to compute-closest-intercept function for points\n");
    return {};
  }
  const double x = symbols.NumberValue(arguments[0]), y = symbols.NumberValue(arguments[1]);
  const double angle = symbols.NumberValue(arguments[2]) * kPi / 180.0;
  const double along_x = std::sin(angle), along_y = std::cos(angle);
  const Symbol name_x = symbols.FindString("x"), name_y = symbols.FindString("y");

  Symbol best;
  double best_distance = std::numeric_limits<double>::infinity();
  std::vector<FunctionContext::Child> points, fields;
  context.AllChildren(arguments[3], points);
  for (const FunctionContext::Child& point : points) {
    if (!point.value.IsIdentifier()) {
      continue;
    }
    fields.clear();
    context.AllChildren(point.value, fields);
    Symbol at_x, at_y;
    for (const FunctionContext::Child& field : fields) {
      (field.attribute == name_x ? at_x : field.attribute == name_y ? at_y : best) =
          field.attribute == name_x || field.attribute == name_y ? field.value : best;
    }
    if (!at_x.IsNumber() || !at_y.IsNumber()) {
      continue;
    }
    const double dx = symbols.NumberValue(at_x) - x, dy = symbols.NumberValue(at_y) - y;
    const double forward = std::max(0.0, dx * along_x + dy * along_y);
    const double off_x = dx - forward * along_x, off_y = dy - forward * along_y;
    const double distance = off_x * off_x + off_y * off_y;
    if (distance < best_distance) {
      best_distance = distance;
      best = point.value;
    }
  }
  return best;
}

Symbol DiceProbability(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 4) {
    return {};
  }
  constexpr const char* kNames[] = {"dice", "sides", "count"};
  constexpr std::int64_t kMostDice = 100000;
  const SymbolTable& symbols = context.symbols();
  std::int64_t in[3];
  for (std::size_t i = 0; i < 3; ++i) {
    if (!arguments[i].IsNumber()) {
      context.PrintError("Error: non-number (" + Name(context, arguments[i]) + ") passed as '" + kNames[i] +
                         "' to - compute-dice-probability\n");
      return {};
    }
    in[i] = ToInt(symbols.NumberValue(arguments[i]));
  }
  const std::string predicate = ToString(symbols, arguments[3], false);
  const auto holds = [&](std::int64_t k) {
    return predicate == "eq"   ? k == in[2]
           : predicate == "ne" ? k != in[2]
           : predicate == "lt" ? k < in[2]
           : predicate == "gt" ? k > in[2]
           : predicate == "le" ? k <= in[2]
                               : k >= in[2];
  };
  if (predicate != "eq" && predicate != "ne" && predicate != "lt" && predicate != "gt" && predicate != "le" && predicate != "ge") {
    context.PrintError("Error: invalid string (" + predicate + ") passed as 'pred' to - compute-dice-probability\n");
    return {};
  }
  const std::int64_t dice = std::min(in[0], kMostDice);
  double probability = 0;
  if (in[1] > 0) {
    for (std::int64_t k = 0; k <= dice; ++k) {
      if (holds(k)) {
        probability += BinomialProbability(dice, k, 1.0 / static_cast<double>(in[1]));
      }
    }
  }
  return context.symbols().Float(std::min(1.0, probability));
}

}  // namespace soarbox::kernel::function_bodies
