// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

/// Soar's value, which is slightly too small; it affects the last degree of headings.
constexpr double kPi = 3.1415926;

/// Truncates towards zero. Values out of range become the smallest integer, as in Soar.
std::int64_t ToInt(double value) {
  constexpr double kLimit = 9223372036854775808.0;
  return value >= -kLimit && value < kLimit ? static_cast<std::int64_t>(value)
                                            : std::numeric_limits<std::int64_t>::min();
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

/// The value of an identifier's attribute, if it is a number.
bool NumberOf(const FunctionContext& context, const SymbolTable& symbols, Symbol identifier, std::string_view attribute,
              double& out) {
  const Symbol name = symbols.FindString(attribute);
  std::vector<FunctionContext::Child> children;
  context.AllChildren(identifier, children);
  for (const FunctionContext::Child& child : children) {
    if (child.attribute == name && child.value.IsNumber()) {
      out = symbols.NumberValue(child.value);
      return true;
    }
  }
  return false;
}

/// The value of an identifier's ^id; the identifier itself if there is none.
Symbol IdOf(const FunctionContext& context, const SymbolTable& symbols, Symbol identifier) {
  const Symbol name = symbols.FindString("id");
  std::vector<FunctionContext::Child> children;
  context.AllChildren(identifier, children);
  for (const FunctionContext::Child& child : children) {
    if (name && child.attribute == name) return child.value;
  }
  return identifier;
}

/// Reads `out.size()` numbers of any kind. Returns false, after an error message, if an argument is not a number.
bool Numbers(FunctionContext& context, Arguments arguments, const char* function, std::span<double> out) {
  for (const Symbol argument : arguments) {
    if (!argument.IsNumber()) {
      context.PrintError("Error: non-number (" + Name(context, argument) + ") passed to - " + function + "\n");
      return false;
    }
  }
  if (arguments.size() != out.size()) {
    return false;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = context.symbols().NumberValue(arguments[i]);
  }
  return true;
}

/// Returns the point below an identifier that is nearest to the ray from (x, y) in the direction of a heading.
Symbol ClosestToRay(FunctionContext& context, Arguments arguments, const std::string& function, double pi) {
  const SymbolTable& symbols = context.symbols();
  if (!arguments[3].IsIdentifier()) {
    context.PrintError("Error: non-symbol (" + Name(context, arguments[3]) + ") passed to " + function +
                       " function for points\n");
    return {};
  }
  const double x = symbols.NumberValue(arguments[0]), y = symbols.NumberValue(arguments[1]);
  const double angle = symbols.NumberValue(arguments[2]) * pi / 180.0;
  const double along_x = std::sin(angle), along_y = std::cos(angle);

  Symbol best;
  double best_distance = std::numeric_limits<double>::infinity();
  std::vector<FunctionContext::Child> points;
  context.AllChildren(arguments[3], points);
  for (const FunctionContext::Child& point : points) {
    if (!point.value.IsIdentifier()) {
      context.PrintError("Error: non-symbol (" + Name(context, point.value) + ") passed to " + function +
                         " function for a point\n");
      return {};
    }
    double at_x = 0, at_y = 0;
    if (!NumberOf(context, symbols, point.value, "x", at_x) || !NumberOf(context, symbols, point.value, "y", at_y)) {
      continue;
    }
    const double dx = at_x - x, dy = at_y - y;
    const double forward = std::max(0.0, dx * along_x + dy * along_y);
    const double off_x = dx - forward * along_x, off_y = dy - forward * along_y;
    const double distance = off_x * off_x + off_y * off_y;
    if (distance < best_distance) {
      best_distance = distance;
      best = IdOf(context, symbols, point.value);
    }
  }
  return best;
}

}  // namespace

// Headings are computed from integer positions; ranges are not.
Symbol Heading(FunctionContext& context, Arguments arguments) {
  double in[4];
  if (!Numbers(context, arguments, "compute-heading", in)) {
    return {};
  }
  const double dx = std::trunc(in[2]) - std::trunc(in[0]), dy = std::trunc(in[3]) - std::trunc(in[1]);
  double heading = 90.0 - std::atan2(dy, dx) * 180.0 / kPi;
  if (heading > 180.0) {
    heading -= 360.0;
  }
  return context.symbols().Integer(ToInt(heading));
}

Symbol Range(FunctionContext& context, Arguments arguments) {
  double in[4];
  if (!Numbers(context, arguments, "compute-range", in)) {
    return {};
  }
  const double dx = in[2] - in[0], dy = in[3] - in[1];
  return context.symbols().Integer(ToInt(std::sqrt(dx * dx + dy * dy)));
}

// Position, heading in degrees, speed and time. As in Soar, the first argument is the start in both directions.
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

/// Arguments: x, y, heading in degrees, and an identifier whose values are points with ^x and ^y. Returns the point
/// nearest to the ray from (x, y) in the direction of the heading.
Symbol ClosestIntercept(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 4) {
    return {};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (!arguments[i].IsInteger()) {
      context.PrintError("Error: non int (" + Name(context, arguments[i]) +
                         ") passed to compute-closest-intercept function.\n");
      return {};
    }
  }
  return ClosestToRay(context, arguments, "compute-closest-intercept", kPi);
}

/// Like ClosestIntercept, for numbers of any kind.
Symbol ClosestToVector(FunctionContext& context, Arguments arguments) {
  double in[3];
  if (arguments.size() != 4 || !Numbers(context, arguments.first(3), "select-point-closest-to-vector", in)) {
    return {};
  }
  return ClosestToRay(context, arguments, "select-point-closest-to-vector", std::numbers::pi);
}

/// Arguments: latitude and longitude of two places, in degrees. Returns their distance in metres along the surface of a
/// sphere with the earth's mean radius.
Symbol Haversine(FunctionContext& context, Arguments arguments) {
  constexpr double kEarthRadius_m = 6371008.8, kRadians = std::numbers::pi / 180.0;
  double in[4];
  if (!Numbers(context, arguments, "haversine", in)) {
    return {};
  }
  const double across = std::sin((in[2] - in[0]) * kRadians / 2.0), along = std::sin((in[3] - in[1]) * kRadians / 2.0);
  const double share = across * across + std::cos(in[0] * kRadians) * std::cos(in[2] * kRadians) * along * along;
  return context.symbols().Float(2.0 * kEarthRadius_m *
                                 std::atan2(std::sqrt(share), std::sqrt(std::max(0.0, 1.0 - share))));
}

/// Arguments: x, y, heading in degrees (0 is towards greater y, 90 towards greater x, as for compute-heading) and
/// distance. Returns the end of the path.
Symbol ExtrapolateX(FunctionContext& context, Arguments arguments) {
  double in[4];
  if (!Numbers(context, arguments, "extrapolate-x-position", in)) {
    return {};
  }
  return context.symbols().Float(in[0] + in[3] * std::sin(in[2] * std::numbers::pi / 180.0));
}

Symbol ExtrapolateY(FunctionContext& context, Arguments arguments) {
  double in[4];
  if (!Numbers(context, arguments, "extrapolate-y-position", in)) {
    return {};
  }
  return context.symbols().Float(in[1] + in[3] * std::cos(in[2] * std::numbers::pi / 180.0));
}

}  // namespace soarbox::kernel::function_bodies
