// SPDX-License-Identifier: BSD-2-Clause
//
// Exponentials, logarithms and powers of floats, computed as doubles.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numerics/exponential.h"
#include "numerics/functions.h"

namespace soarbox::numerics {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kRound = 0x1.8p52;
constexpr double kStepsPerUnit = 0x1.71547652b82fep+5;  // 32 / ln 2
constexpr double kUnit = 1 / kStepsPerUnit;

// 2^(i/32), by repeated square roots of 2.
constexpr std::array<double, 32> kPowers = [] {
  constexpr double kRoots[] = {0x1.6a09e667f3bcdp+0, 0x1.306fe0a31b715p+0, 0x1.172b83c7d517bp+0, 0x1.0b5586cf9890fp+0,
                               0x1.059b0d3158574p+0};
  std::array<double, 32> table{};
  for (int i = 0; i < 32; ++i) {
    DoubleDouble power{1, 0};
    for (int bit = 0; bit < 5; ++bit)
      if (i >> (4 - bit) & 1) power = Multiply(power, kRoots[bit]);
    table[i] = power.hi;
  }
  return table;
}();

/// e^x for |x| < 700, with a relative error below 2^-44.
double FastExp(double x) {
  const double rounded = x * kStepsPerUnit + kRound - kRound;
  const auto steps = static_cast<std::int64_t>(rounded);
  const double r = x - rounded * kUnit;
  const double value =
      kPowers[steps & 31] * (1 + (r + r * r * (1.0 / 2 + r * (1.0 / 6 + r * (1.0 / 24 + r * (1.0 / 120))))));
  return value * std::bit_cast<double>(static_cast<std::uint64_t>((steps >> 5) + 1023) << 52);
}

}  // namespace

float Exp(float x) {
  if (!(x > -104 && x < 89)) return x < 0 ? 0.0F : x > 0 ? kInfinity : x;
  return static_cast<float>(FastExp(x));
}

float Log(float x) {
  return static_cast<float>(x > 0 && x < kInfinity ? FastLogOf(x) : Log(static_cast<double>(x)));
}

float Pow(float x, float y) {
  if (!(x > 0 && x < kInfinity && std::abs(y) < 1e9F))
    return static_cast<float>(Pow(static_cast<double>(x), static_cast<double>(y)));
  const double estimate = FastLogOf(x) * y;
  if (!(estimate > -104 && estimate < 89)) return estimate < 0 ? 0.0F : kInfinity;
  return static_cast<float>(FastExp(estimate));
}

}  // namespace soarbox::numerics
