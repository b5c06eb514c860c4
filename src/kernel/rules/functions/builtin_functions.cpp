// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/functions/builtin_functions.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/rules/functions/function_bodies.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

namespace {

using namespace function_bodies;

constexpr int kAny = -1;

/// name, arguments, as value, as action, literalizes, body
constexpr BuiltinFunction kFunctions[] = {
    // Text and control
    {"write", kAny, false, true, false, Write},
    {"crlf", 0, true, false, false, Crlf},
    {"halt", 0, false, true, false, Halt},
    {"interrupt", 0, false, true, false, Interrupt},
    {"wait", 1, false, true, false, Wait},
    {"count", kAny, false, true, false, Count},
    {"log", kAny, false, true, false, Log},
    {"trace", kAny, false, true, false, Trace},
    {"exec", kAny, true, true, false, Exec},
    {"cmd", kAny, true, true, false, Cmd},
    {"dc", 0, true, false, false, DecisionCycle},
    {"timestamp", 0, true, false, false, Timestamp},
    {"accept", 0, true, false, false, Accept},
    // Learning and long-term memory
    {"dont-learn", 1, false, true, false, DontLearn},
    {"force-learn", 1, false, true, false, ForceLearn},
    {"link-stm-to-ltm", 2, false, true, false, LinkToLongTerm},
    {"@", 1, true, false, false, LongTermNumber},
    // Text values
    {"concat", kAny, true, false, false, Concat},
    {"string", 1, true, false, true, ToText},
    {"make-constant-symbol", kAny, true, false, false, MakeConstant},
    {"capitalize-symbol", 1, true, false, false, Capitalize},
    {"trim", 1, true, false, false, Trim},
    {"strlen", 1, true, false, false, TextLength},
    {"ifeq", 4, true, false, false, IfEqual},
    // Arithmetic
    {"+", kAny, true, false, true, Plus},
    {"*", kAny, true, false, true, Times},
    {"-", kAny, true, false, true, Minus},
    {"/", kAny, true, false, true, Divide},
    {"div", 2, true, false, true, IntegerDivide},
    {"mod", 2, true, false, true, Modulo},
    {"min", kAny, true, false, true, Minimum},
    {"max", kAny, true, false, true, Maximum},
    {"abs", 1, true, false, true, Absolute},
    {"sqrt", 1, true, false, true, SquareRoot},
    {"sin", 1, true, false, true, Sine},
    {"cos", 1, true, false, true, Cosine},
    {"atan2", 2, true, false, true, ArcTangent},
    {"int", 1, true, false, true, ToInteger},
    {"float", 1, true, false, true, ToFloat},
    {"rand-int", kAny, true, false, true, RandomInteger},
    {"rand-float", kAny, true, false, true, RandomFloat},
    // Space
    {"round-off", 2, true, false, true, RoundOff},
    {"round-off-heading", 2, true, false, true, RoundOffHeading},
    {"compute-heading", 4, true, false, true, Heading},
    {"compute-range", 4, true, false, true, Range},
    {"predict-x", 4, true, false, true, PredictX},
    {"predict-y", 4, true, false, true, PredictY},
    {"compute-closest-intercept", 4, true, false, true, ClosestIntercept},
    {"compute-dice-probability", 4, true, false, true, DiceProbability},
    // Working memory
    {"size", 1, true, false, true, Size},
    {"sum", 1, true, false, true, Sum},
    {"product", 1, true, false, true, Product},
    {"set-count", kAny, true, false, true, SetCount},
    {"set-sum", kAny, true, false, true, SetSum},
    {"set-multiply", kAny, true, false, true, SetMultiply},
    {"set-min", kAny, true, false, true, SetMinimum},
    {"set-max", kAny, true, false, true, SetMaximum},
    {"set-range", kAny, true, false, true, SetRange},
    {"set-mean", kAny, true, false, true, SetMean},
    {"set-stdev", kAny, true, false, true, SetDeviation},
    {"deep-copy", 1, true, false, false, DeepCopy},
    {"from-st-xml", 1, true, false, false, FromXml},
    // Navigation, since 9.6.4
    {"haversine", 4, true, false, true, Haversine},
    {"extrapolate-x-position", 4, true, false, true, ExtrapolateX},
    {"extrapolate-y-position", 4, true, false, true, ExtrapolateY},
    {"select-point-closest-to-vector", 4, true, false, true, ClosestToVector},
};

}  // namespace

std::span<const BuiltinFunction> BuiltinFunctions() {
  return kFunctions;
}

std::uint16_t FindBuiltinFunction(std::string_view name) {
  std::uint16_t index = 0;
  for (const BuiltinFunction& function : kFunctions) {
    if (function.name == name) {
      return index;
    }
    ++index;
  }
  return RhsValue::kUserFunction;
}

std::string_view NearestFunction(std::string_view name) {
  constexpr std::string_view kPrinters[] = {"print", "printf", "println", "echo", "say", "log", "puts", "display"};
  if (std::ranges::find(kPrinters, name) != std::end(kPrinters)) return "write";
  std::vector<std::string_view> names;
  for (const BuiltinFunction& function : kFunctions) names.push_back(function.name);
  const std::string_view near = Suggest(name, names);
  return near.empty() && name.starts_with("rand") ? "rand-int or rand-float" : near;
}

Symbol Evaluate(FunctionContext& context, std::uint16_t function_index, std::span<const Symbol> arguments) {
  if (function_index >= std::size(kFunctions)) {
    return {};
  }
  return kFunctions[function_index].evaluate(context, arguments);
}

}  // namespace soarbox::kernel
