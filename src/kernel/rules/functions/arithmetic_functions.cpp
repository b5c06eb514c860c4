// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

#include "diagnostics/number_from_chars.h"
#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

// Integers wrap around on overflow, as in Soar; unsigned arithmetic makes this well defined.
std::int64_t WrappingAdd(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}
std::int64_t WrappingSubtract(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}
std::int64_t WrappingMultiply(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b));
}

/// Returns true if all arguments are numbers; else reports the first that is not.
bool AllNumbers(FunctionContext& context, Arguments arguments, const char* function) {
  for (const Symbol argument : arguments) {
    if (!argument.IsNumber()) {
      context.PrintError("Error: non-number (" + Name(context, argument) + ") passed to " + function + " function\n");
      return false;
    }
  }
  return true;
}

bool AllIntegers(Arguments arguments) {
  return std::all_of(arguments.begin(), arguments.end(), [](Symbol argument) { return argument.IsInteger(); });
}

/// Folds numbers: as integers if all of them are integers, else as floats.
template <typename IntegerStep, typename FloatStep>
Symbol Fold(FunctionContext& context, Arguments arguments, std::int64_t start, IntegerStep integer_step,
            FloatStep float_step) {
  SymbolTable& symbols = context.symbols();
  if (AllIntegers(arguments)) {
    std::int64_t result = start;
    for (const Symbol argument : arguments) {
      result = integer_step(result, symbols.IntegerValue(argument));
    }
    return symbols.Integer(result);
  }
  double result = static_cast<double>(start);
  for (const Symbol argument : arguments) {
    result = float_step(result, symbols.NumberValue(argument));
  }
  return symbols.Float(result);
}

/// The smallest or largest number; a float if any argument is one.
template <typename IntegerPick, typename FloatPick>
Symbol Extreme(FunctionContext& context, Arguments arguments, const char* function, IntegerPick integer_pick,
               FloatPick float_pick) {
  SymbolTable& symbols = context.symbols();
  if (!AllNumbers(context, arguments, function)) {
    return {};
  }
  if (arguments.empty()) {
    return symbols.Integer(0);
  }
  if (AllIntegers(arguments)) {
    std::int64_t result = symbols.IntegerValue(arguments[0]);
    for (const Symbol argument : arguments) {
      result = integer_pick(result, symbols.IntegerValue(argument));
    }
    return symbols.Integer(result);
  }
  double result = symbols.NumberValue(arguments[0]);
  for (const Symbol argument : arguments) {
    result = float_pick(result, symbols.NumberValue(argument));
  }
  return symbols.Float(result);
}

/// Applies a function of one number; the result is a float.
Symbol OfOneNumber(FunctionContext& context, Arguments arguments, const char* function, double (*apply)(double)) {
  if (arguments.size() != 1 || !arguments[0].IsNumber()) {
    context.PrintError("Error: '" + std::string(function) + "' function called with non-numeric argument " +
                       (arguments.empty() ? std::string() : Name(context, arguments[0])) + "\n");
    return {};
  }
  return context.symbols().Float(apply(context.symbols().NumberValue(arguments[0])));
}

/// Returns true if the arguments are two integers and the second is not zero; else reports the error.
bool TwoIntegers(FunctionContext& context, Arguments arguments, const char* function) {
  for (const Symbol argument : arguments) {
    if (!argument.IsInteger()) {
      context.PrintError("Error: non-integer (" + Name(context, argument) + ") passed to " + function + " function\n");
      return false;
    }
  }
  if (arguments.size() != 2) {
    return false;
  }
  if (context.symbols().IntegerValue(arguments[1]) == 0) {
    context.PrintError("Error: attempt to divide ('" + std::string(function) + "') by zero.\n");
    return false;
  }
  return true;
}

/// Truncates towards zero. Values out of range become the smallest integer, as in Soar.
std::int64_t TruncatedToInteger(double value) {
  constexpr double kLimit = 9223372036854775808.0;
  if (value >= -kLimit && value < kLimit) {
    return static_cast<std::int64_t>(value);
  }
  return std::numeric_limits<std::int64_t>::min();
}

/// The text of a number without leading blanks, and without a plus sign before a digit or a dot.
std::string_view NumberText(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\n\v\f\r");
  text = start == std::string_view::npos ? std::string_view() : text.substr(start);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') {
    text.remove_prefix(1);
  }
  return text;
}

/// Reads the number at the beginning of a text; 0 if there is none. Returns false if it is out of range.
bool ReadFloat(std::string_view text, double& value) {
  text = NumberText(text);
  const bool negative = !text.empty() && text[0] == '-';
  const std::string_view digits = text.substr(negative ? 1 : 0);
  if (digits.size() > 2 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X')) {
    const auto read = NumberFromChars(digits.substr(2), value, std::chars_format::hex);
    value = negative ? -value : value;
    return read.ec != std::errc::result_out_of_range;
  }
  return NumberFromChars(text, value).ec != std::errc::result_out_of_range;
}

}  // namespace

Symbol Plus(FunctionContext& context, Arguments arguments) {
  if (!AllNumbers(context, arguments, "+")) {
    return {};
  }
  return Fold(context, arguments, 0, WrappingAdd, [](double a, double b) { return a + b; });
}

Symbol Times(FunctionContext& context, Arguments arguments) {
  if (!AllNumbers(context, arguments, "*")) {
    return {};
  }
  return Fold(context, arguments, 1, WrappingMultiply, [](double a, double b) { return a * b; });
}

Symbol Minus(FunctionContext& context, Arguments arguments) {
  if (arguments.empty()) {
    context.PrintError("Error: '-' function called with no arguments\n");
    return {};
  }
  if (!AllNumbers(context, arguments, "-")) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  if (arguments.size() == 1) {
    return arguments[0].IsInteger() ? symbols.Integer(WrappingSubtract(0, symbols.IntegerValue(arguments[0])))
                                    : symbols.Float(-symbols.FloatValue(arguments[0]));
  }
  const Arguments rest = arguments.subspan(1);
  if (AllIntegers(arguments)) {
    return Fold(context, rest, symbols.IntegerValue(arguments[0]), WrappingSubtract,
                [](double a, double) { return a; });
  }
  double result = symbols.NumberValue(arguments[0]);
  for (const Symbol argument : rest) {
    result -= symbols.NumberValue(argument);
  }
  return symbols.Float(result);
}

Symbol Divide(FunctionContext& context, Arguments arguments) {
  if (arguments.empty()) {
    context.PrintError("Error: '/' function called with no arguments\n");
    return {};
  }
  if (!AllNumbers(context, arguments, "/")) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  double result = arguments.size() == 1 ? 1.0 : symbols.NumberValue(arguments[0]);
  for (const Symbol argument : arguments.size() == 1 ? arguments : arguments.subspan(1)) {
    const double divisor = symbols.NumberValue(argument);
    if (divisor == 0) {
      context.PrintError("Error: attempt to divide ('/') by zero.\n");
      return {};
    }
    result /= divisor;
  }
  return symbols.Float(result);
}

Symbol IntegerDivide(FunctionContext& context, Arguments arguments) {
  if (!TwoIntegers(context, arguments, "div")) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  const std::int64_t a = symbols.IntegerValue(arguments[0]), b = symbols.IntegerValue(arguments[1]);
  return symbols.Integer(b == -1 ? WrappingSubtract(0, a) : a / b);
}

Symbol Modulo(FunctionContext& context, Arguments arguments) {
  if (!TwoIntegers(context, arguments, "mod")) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  const std::int64_t a = symbols.IntegerValue(arguments[0]), b = symbols.IntegerValue(arguments[1]);
  return symbols.Integer(b == -1 ? 0 : a % b);
}

Symbol Minimum(FunctionContext& context, Arguments arguments) {
  return Extreme(
      context, arguments, "min", [](std::int64_t a, std::int64_t b) { return std::min(a, b); },
      [](double a, double b) { return std::min(a, b); });
}

Symbol Maximum(FunctionContext& context, Arguments arguments) {
  return Extreme(
      context, arguments, "max", [](std::int64_t a, std::int64_t b) { return std::max(a, b); },
      [](double a, double b) { return std::max(a, b); });
}

Symbol Absolute(FunctionContext& context, Arguments arguments) {
  if (arguments.size() == 1 && arguments[0].IsInteger()) {
    const std::int64_t value = context.symbols().IntegerValue(arguments[0]);
    return context.symbols().Integer(value < 0 ? WrappingSubtract(0, value) : value);
  }
  return OfOneNumber(context, arguments, "abs", [](double x) { return std::fabs(x); });
}

Symbol SquareRoot(FunctionContext& context, Arguments arguments) {
  return OfOneNumber(context, arguments, "sqrt", [](double x) { return std::sqrt(x); });
}
Symbol Sine(FunctionContext& context, Arguments arguments) {
  return OfOneNumber(context, arguments, "sin", [](double x) { return std::sin(x); });
}
Symbol Cosine(FunctionContext& context, Arguments arguments) {
  return OfOneNumber(context, arguments, "cos", [](double x) { return std::cos(x); });
}

Symbol ArcTangent(FunctionContext& context, Arguments arguments) {
  for (const Symbol argument : arguments) {
    if (!argument.IsNumber()) {
      context.PrintError("Error: non-number (" + Name(context, argument) + ") passed to atan2\n");
      return {};
    }
  }
  if (arguments.size() != 2) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  return symbols.Float(std::atan2(symbols.NumberValue(arguments[0]), symbols.NumberValue(arguments[1])));
}

Symbol ToInteger(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  const Symbol argument = arguments[0];
  if (argument.IsInteger()) {
    return argument;
  }
  if (argument.IsFloat()) {
    return symbols.Integer(TruncatedToInteger(symbols.FloatValue(argument)));
  }
  if (!argument.IsString()) {
    context.PrintError("Error: identifier (" + Name(context, argument) + ") passed to 'int' RHS function.\n");
    return {};
  }
  const std::string_view text = NumberText(symbols.Text(argument));
  std::int64_t value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc::result_out_of_range) {
    context.PrintError("Error: bad integer (" + Name(context, argument) + ") given to 'int' RHS function\n");
    return {};
  }
  return symbols.Integer(value);
}

Symbol ToFloat(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  const Symbol argument = arguments[0];
  if (argument.IsNumber()) {
    return symbols.Float(symbols.NumberValue(argument));
  }
  if (!argument.IsString()) {
    context.PrintError("Error: identifier (" + Name(context, argument) + ") passed to 'float' RHS function.\n");
    return {};
  }
  double value = 0;
  if (!ReadFloat(symbols.Text(argument), value)) {
    context.PrintError("Error: bad float (" + Name(context, argument) + ") given to 'float' RHS function\n");
    return {};
  }
  return symbols.Float(value);
}

}  // namespace soarbox::kernel::function_bodies
