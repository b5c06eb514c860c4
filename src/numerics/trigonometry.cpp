// SPDX-License-Identifier: BSD-2-Clause
//
// Sine, cosine and tangent: the angle is reduced by a multiple of pi/2; then tables are used for its leading bits and
// series for the remainder.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numerics/double_double.h"
#include "numerics/functions.h"
#include "numerics/reduction.h"

namespace soarbox::numerics {
namespace {

struct SineCosine {
  DoubleDouble sine, cosine;
};

constexpr SineCosine BySeries(double x) {
  const DoubleDouble square = TwoProduct(x, x);
  DoubleDouble sine{1, 0}, cosine{1, 0};
  for (int n = 28; n >= 2; n -= 2) {
    cosine = Add(Negative(Divide(Multiply(square, cosine), {static_cast<double>(n * (n - 1)), 0})), 1.0);
    sine = Add(Negative(Divide(Multiply(square, sine), {static_cast<double>(n * (n + 1)), 0})), 1.0);
  }
  return {Multiply(sine, x), cosine};
}

// Sine and cosine of i/64, up to pi/4.
constexpr int kAngles = 52;
constexpr std::array<SineCosine, kAngles> kTable = [] {
  std::array<SineCosine, kAngles> table{};
  for (int i = 0; i < kAngles; ++i) table[i] = BySeries(i / 64.0);
  return table;
}();

/// An angle from -pi/4 to pi/4 as the sum of a tabulated angle with its sign and a rest of at most 1/128.
struct Split {
  SineCosine table;
  DoubleDouble rest;
  double sine_less;    ///< (sin(rest) - rest) / rest
  double cosine_less;  ///< cos(rest) - 1
};

Split SplitAngle(DoubleDouble angle) {
  const double size = std::abs(angle.hi);
  const int index = static_cast<int>(size * 64 + 0.5);
  Split split{kTable[index], {}, 0, 0};
  if (angle.hi < 0) split.table.sine = Negative(split.table.sine);
  split.rest = TwoSum(angle.hi - std::copysign(index / 64.0, angle.hi), angle.lo);
  const double square = split.rest.hi * split.rest.hi;
  split.sine_less = square * (-1.0 / 6 + square * (1.0 / 120 + square * (-1.0 / 5040)));
  split.cosine_less = square * (-1.0 / 2 + square * (1.0 / 24 + square * (-1.0 / 720 + square * (1.0 / 40320))));
  return split;
}

DoubleDouble SineOf(const Split& split) {
  const auto& [sine, cosine] = split.table;
  const double d = split.rest.hi;
  const DoubleDouble product = TwoProduct(cosine.hi, d);
  const DoubleDouble sum = TwoSum(sine.hi, product.hi);
  const double low = product.lo + sine.lo + cosine.hi * split.rest.lo + cosine.lo * d + product.hi * split.sine_less +
                     sine.hi * (split.cosine_less - d * split.rest.lo);
  return FastTwoSum(sum.hi, sum.lo + low);
}

DoubleDouble CosineOf(const Split& split) {
  const auto& [sine, cosine] = split.table;
  const double d = split.rest.hi;
  const DoubleDouble product = TwoProduct(sine.hi, -d);
  const DoubleDouble sum = FastTwoSum(cosine.hi, product.hi);
  const double low = product.lo + cosine.lo - sine.hi * split.rest.lo - sine.lo * d + product.hi * split.sine_less +
                     cosine.hi * (split.cosine_less - d * split.rest.lo);
  return FastTwoSum(sum.hi, sum.lo + low);
}

double Rounded(DoubleDouble value) {
  return value.hi + value.lo;
}

/// The sine of the angle plus `quadrants` right angles.
double SineInQuadrant(DoubleDouble angle, int quadrants) {
  const Split split = SplitAngle(angle);
  const double value = Rounded(quadrants & 1 ? CosineOf(split) : SineOf(split));
  return quadrants & 2 ? -value : value;
}

/// Same in double precision, for floats: series up to pi/4.
double FastSineInQuadrant(double angle, int quadrants) {
  const double square = angle * angle;
  double value;
  if (quadrants & 1)
    value =
        1 + square *
                (-1.0 / 2 +
                 square * (1.0 / 24 +
                           square * (-1.0 / 720 +
                                     square * (1.0 / 40320 + square * (-1.0 / 3628800 + square * (1.0 / 479001600))))));
  else
    value = angle +
            angle * square *
                (-1.0 / 6 +
                 square * (1.0 / 120 + square * (-1.0 / 5040 + square * (1.0 / 362880 + square * (-1.0 / 39916800)))));
  return quadrants & 2 ? -value : value;
}

constexpr double kTiny = 0x1p-27;

}  // namespace

double Sin(double x) {
  if (std::abs(x) < kTiny || !std::isfinite(x)) return std::isfinite(x) ? x : x - x;
  const Reduced reduced = Reduce(x);
  return SineInQuadrant(reduced.angle, reduced.quadrants);
}

double Cos(double x) {
  if (!std::isfinite(x)) return x - x;
  const Reduced reduced = Reduce(x);
  return SineInQuadrant(reduced.angle, reduced.quadrants + 1);
}

double Tan(double x) {
  if (std::abs(x) < kTiny || !std::isfinite(x)) return std::isfinite(x) ? x : x - x;
  const Reduced reduced = Reduce(x);
  const Split split = SplitAngle(reduced.angle);
  const DoubleDouble sine = SineOf(split), cosine = CosineOf(split);
  return Rounded(reduced.quadrants & 1 ? Negative(Divide(cosine, sine)) : Divide(sine, cosine));
}

float Sin(float x) {
  if (std::abs(x) < 0x1p-12F || !std::isfinite(x)) return std::isfinite(x) ? x : x - x;
  const FastReduced reduced = FastReduce(x);
  return static_cast<float>(FastSineInQuadrant(reduced.angle, reduced.quadrants));
}

float Cos(float x) {
  if (!std::isfinite(x)) return x - x;
  const FastReduced reduced = FastReduce(x);
  return static_cast<float>(FastSineInQuadrant(reduced.angle, reduced.quadrants + 1));
}

float Tan(float x) {
  if (std::abs(x) < 0x1p-12F || !std::isfinite(x)) return std::isfinite(x) ? x : x - x;
  const FastReduced reduced = FastReduce(x);
  return static_cast<float>(FastSineInQuadrant(reduced.angle, reduced.quadrants) /
                            FastSineInQuadrant(reduced.angle, reduced.quadrants + 1));
}

}  // namespace soarbox::numerics
