// SPDX-License-Identifier: BSD-2-Clause
//
// The inverse functions of sine, cosine and tangent. Each is computed as the angle of a point (x, y): the sum of a
// tabulated angle and a series for the rest.
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/double_double.h"
#include "numerics/functions.h"

namespace soarbox::numerics {
namespace {

constexpr DoubleDouble kPi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr DoubleDouble kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

constexpr DoubleDouble ArcBySeries(DoubleDouble x) {
  const DoubleDouble square = Multiply(x, x);
  DoubleDouble sum;
  for (int n = 19; n >= 1; n -= 2)
    sum = Add(Negative(Multiply(square, sum)), Divide({1, 0}, {static_cast<double>(n), 0}));
  return Multiply(sum, x);
}

// The arc tangent of i/64, computed from the previous one and the angle between them.
constexpr int kArcs = 65;
constexpr std::array<DoubleDouble, kArcs> kTable = [] {
  std::array<DoubleDouble, kArcs> table{};
  for (int i = 1; i < kArcs; ++i) {
    const double before = (i - 1) / 64.0, now = i / 64.0;
    table[i] = Add(table[i - 1], ArcBySeries(Divide({1 / 64.0, 0}, {1 + before * now, 0})));
  }
  return table;
}();

/// The arc tangent of y/x for 0 <= y <= x, x > 0.
DoubleDouble ArcOf(DoubleDouble y, DoubleDouble x) {
  const int index = static_cast<int>(64 * (y.hi / x.hi) + 0.5);
  const double c = index / 64.0;
  const DoubleDouble u = index == 0 ? Divide(y, x) : Divide(Add(y, Negative(Multiply(x, c))), Add(x, Multiply(y, c)));
  const double square = u.hi * u.hi;
  const double tail = u.hi * square * (-1.0 / 3 + square * (1.0 / 5 + square * (-1.0 / 7 + square * (1.0 / 9))));
  return Add(kTable[index], Add(u, tail));
}

/// The same for any signs: from -pi to pi. Not defined for (0, 0).
DoubleDouble AngleOf(DoubleDouble y, DoubleDouble x) {
  const bool below = std::signbit(y.hi), behind = std::signbit(x.hi);
  if (below) y = Negative(y);
  if (behind) x = Negative(x);
  DoubleDouble angle = y.hi <= x.hi ? ArcOf(y, x) : Add(kHalfPi, Negative(ArcOf(x, y)));
  if (behind) angle = Add(kPi, Negative(angle));
  return below ? Negative(angle) : angle;
}

double Rounded(DoubleDouble value) {
  return value.hi + value.lo;
}

/// The square root of (1 - x)(1 + x).
DoubleDouble OtherSide(double x) {
  const DoubleDouble square = Multiply(TwoSum(1, -x), TwoSum(1, x));
  const double root = std::sqrt(square.hi);
  if (root == 0) return {};
  const DoubleDouble rest = Add(square, Negative(TwoProduct(root, root)));
  return FastTwoSum(root, (rest.hi + rest.lo) / (2 * root));
}

// The tables for floats, in double precision: arc tangents of i/16.
constexpr int kFewArcs = 17;
constexpr std::array<double, kFewArcs> kFewTable = [] {
  std::array<double, kFewArcs> table{};
  for (int i = 0; i < kFewArcs; ++i) table[i] = kTable[4 * i].hi;
  return table;
}();

double FastArcOf(double y, double x) {
  const int index = static_cast<int>(16 * (static_cast<float>(y) / static_cast<float>(x)) + 0.5F);
  const double c = index / 16.0;
  const double u = (y - c * x) / (x + c * y);
  const double square = u * u;
  return kFewTable[index] +
         (u + u * square * (-1.0 / 3 + square * (1.0 / 5 + square * (-1.0 / 7 + square * (1.0 / 9)))));
}

double FastAngleOf(double y, double x) {
  const bool below = std::signbit(y), behind = std::signbit(x);
  y = std::abs(y);
  x = std::abs(x);
  double angle = y <= x ? FastArcOf(y, x) : kHalfPi.hi - FastArcOf(x, y);
  if (behind) angle = kPi.hi - angle;
  return below ? -angle : angle;
}

/// The results that C defines for zeros and infinities. Returns true if `angle` is such a result.
template <class Real>
bool IsSpecial(Real y, Real x, double& angle) {
  if (std::isnan(x) || std::isnan(y)) {
    angle = x + y;
  } else if (y == 0) {
    angle = std::signbit(x) ? kPi.hi : 0;
  } else if (std::isinf(x)) {
    angle = std::isinf(y) ? (x < 0 ? 0.75 * kPi.hi : 0.25 * kPi.hi) : x < 0 ? kPi.hi : 0;
  } else if (std::isinf(y) || x == 0) {
    angle = kHalfPi.hi;
  } else {
    return false;
  }
  if (!std::isnan(angle)) angle = std::copysign(angle, y);
  return true;
}

}  // namespace

double Atan2(double y, double x) {
  double angle = 0;
  if (IsSpecial(y, x, angle)) return angle;
  // Avoids overflow and underflow of products and quotients.
  int of_y = 0, of_x = 0;
  double y_part = std::frexp(y, &of_y), x_part = std::frexp(x, &of_x);
  if (of_y - of_x > 80) return std::copysign(kHalfPi.hi, y);
  if (of_x - of_y > 80) {
    if (x < 0) return std::copysign(kPi.hi, y);
    return std::copysign(std::abs(y) / x, y);
  }
  y_part = std::ldexp(y_part, of_y - of_x);
  return Rounded(AngleOf({y_part, 0}, {x_part, 0}));
}

double Atan(double x) {
  return std::abs(x) < 0x1p-27 ? x : Atan2(x, 1);
}

double Asin(double x) {
  if (std::isnan(x) || std::abs(x) > 1) return std::isnan(x) ? x : std::numeric_limits<double>::quiet_NaN();
  if (std::abs(x) < 0x1p-27) return x;
  if (std::abs(x) == 1) return std::copysign(kHalfPi.hi, x);
  return Rounded(AngleOf({x, 0}, OtherSide(x)));
}

double Acos(double x) {
  if (std::isnan(x) || std::abs(x) > 1) return std::isnan(x) ? x : std::numeric_limits<double>::quiet_NaN();
  if (x == 1) return 0;
  if (x == -1) return kPi.hi;
  if (x == 0) return kHalfPi.hi;
  return Rounded(AngleOf(OtherSide(x), {x, 0}));
}

double Hypot(double x, double y) {
  x = std::abs(x);
  y = std::abs(y);
  if (std::isinf(x) || std::isinf(y)) return std::numeric_limits<double>::infinity();
  if (std::isnan(x) || std::isnan(y)) return x + y;
  if (x < y) std::swap(x, y);
  if (y == 0) return x;
  int exponent = 0, other = 0;
  x = std::frexp(x, &exponent);
  y = std::frexp(y, &other);
  if (exponent - other > 60) return std::ldexp(x, exponent);
  y = std::ldexp(y, other - exponent);
  const DoubleDouble square = Add(TwoProduct(x, x), TwoProduct(y, y));
  const double root = std::sqrt(square.hi);
  const DoubleDouble rest = Add(square, Negative(TwoProduct(root, root)));
  return std::ldexp(root + (rest.hi + rest.lo) / (2 * root), exponent);
}

float Atan2(float y, float x) {
  double angle = 0;
  if (IsSpecial(y, x, angle)) return static_cast<float>(angle);
  return static_cast<float>(FastAngleOf(y, x));
}

float Atan(float x) {
  return std::abs(x) < 0x1p-12F ? x : Atan2(x, 1.0F);
}

float Asin(float x) {
  if (std::isnan(x) || std::abs(x) > 1) return std::isnan(x) ? x : std::numeric_limits<float>::quiet_NaN();
  if (std::abs(x) < 0x1p-12F) return x;
  const double value = x;
  return static_cast<float>(FastAngleOf(value, std::sqrt((1 - value) * (1 + value))));
}

float Acos(float x) {
  if (std::isnan(x) || std::abs(x) > 1) return std::isnan(x) ? x : std::numeric_limits<float>::quiet_NaN();
  const double value = x;
  return static_cast<float>(FastAngleOf(std::sqrt((1 - value) * (1 + value)), value));
}

}  // namespace soarbox::numerics
