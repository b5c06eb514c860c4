// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

/// Maximum number of dice, because the time grows with it.
constexpr double kMostDice = 1e6;

bool Holds(std::string_view predicate, double left, double right) {
  return predicate == "eq"   ? left == right
         : predicate == "ne" ? left != right
         : predicate == "lt" ? left < right
         : predicate == "gt" ? left > right
         : predicate == "le" ? left <= right
                             : left >= right;
}

}  // namespace

/// Computes a probability from the number of dice, the number of sides, a count and a comparison. It is the probability
/// that the number of dice that show one given side is eq, ne, lt, gt, le or ge the count. Uses logarithms, so that
/// many dice do not overflow.
Symbol DiceProbability(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 4) {
    return {};
  }
  constexpr const char* kNames[] = {"dice", "sides", "count"};
  SymbolTable& symbols = context.symbols();
  double in[3];
  for (std::size_t i = 0; i < 3; ++i) {
    if (!arguments[i].IsNumber()) {
      context.PrintError("Error: non-number (" + ToString(symbols, arguments[i]) + ") passed as '" + kNames[i] +
                         "' to - compute-dice-probability\n");
      return {};
    }
    in[i] = std::trunc(symbols.NumberValue(arguments[i]));
  }
  if (!arguments[3].IsString()) {
    context.PrintError("Error: non-string (" + ToString(symbols, arguments[3]) +
                       ") passed as 'pred' to - compute-dice-probability\n");
    return {};
  }
  const std::string predicate(symbols.Text(arguments[3]));
  constexpr std::array<std::string_view, 6> kPredicates = {"eq", "ne", "lt", "gt", "le", "ge"};
  if (std::find(kPredicates.begin(), kPredicates.end(), predicate) == kPredicates.end()) {
    context.PrintError("Error: invalid string (" + ToString(symbols, arguments[3]) +
                       ") passed as 'pred' to - compute-dice-probability\n");
    return {};
  }
  if (!(in[0] <= kMostDice)) {
    context.PrintError("Error: more than a million dice (" + ToString(symbols, arguments[0]) +
                       ") passed to - compute-dice-probability\n");
    return {};
  }
  const double dice = std::max(0.0, in[0]), sides = in[1], count = in[2];
  if (!(sides >= 1)) {
    return symbols.Float(0.0);
  }
  if (sides == 1) {
    return symbols.Float(Holds(predicate, dice, count) ? 1.0 : 0.0);
  }
  const double chance = 1 / sides, step = std::log(chance) - std::log1p(-chance);
  double logarithm = dice * std::log1p(-chance), probability = 0;
  for (double shown = 0; shown <= dice; ++shown) {
    if (Holds(predicate, shown, count)) {
      probability += std::exp(logarithm);
    }
    logarithm += std::log((dice - shown) / (shown + 1)) + step;
  }
  return symbols.Float(std::min(1.0, probability));
}

}  // namespace soarbox::kernel::function_bodies
