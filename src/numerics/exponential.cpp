// SPDX-License-Identifier: BSD-2-Clause
//
// Exponentials, logarithms and powers: a table for the leading bits, a short polynomial for the remainder.
#include "numerics/exponential.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numerics/functions.h"

namespace soarbox::numerics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kRound = 0x1.8p52;  // Adding and subtracting it rounds to an integer.
constexpr DoubleDouble kLn2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr DoubleDouble kReciprocalOfLn2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
constexpr DoubleDouble kReciprocalOfLn10{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

/// e^x for a small x, by its power series.
constexpr DoubleDouble ExpBySeries(DoubleDouble x) {
  DoubleDouble sum{1, 0};
  for (int n = 24; n >= 1; --n) sum = Add(Multiply(Divide(x, {static_cast<double>(n), 0}), sum), 1.0);
  return sum;
}

// 2^(i/64).
constexpr int kPowers = 64;
constexpr double kPowersPerUnit = 0x1.71547652b82fep+6;  // 64 / ln 2
constexpr double kUnitHi = 0x1.62e42fefap-7;             // ln 2 / 64: the leading 36 bits, and the remainder.
constexpr double kUnitLo = 0x1.cf79abc9e3b3ap-46;
constexpr std::array<DoubleDouble, kPowers> kPowersOfTwo = [] {
  std::array<DoubleDouble, kPowers> table{};
  for (int i = 0; i < kPowers; ++i) table[i] = ExpBySeries(Multiply(kLn2, i / 64.0));
  return table;
}();

/// log(1 + z) for a small z, by the series of the inverse hyperbolic tangent: 2 * atanh(z / (2 + z)).
constexpr DoubleDouble LogBySeries(double z) {
  const DoubleDouble ratio = Divide({z, 0}, TwoSum(2, z));
  const DoubleDouble square = Multiply(ratio, ratio);
  DoubleDouble sum{0, 0};
  for (int n = 45; n >= 1; n -= 2) sum = Add(Multiply(sum, square), Divide({1, 0}, {static_cast<double>(n), 0}));
  return Multiply(Multiply(sum, ratio), 2);
}

// For each value of the leading seven bits of a mantissa m: a number c of nine bits close to 1/m, and -log(c). Near 1,
// c is 1.
struct Inverse {
  double c = 1;
  DoubleDouble minus_log;
};
constexpr int kInverses = 128;
constexpr std::array<Inverse, kInverses> kInversesOf = [] {
  std::array<Inverse, kInverses> table{};
  for (int i = 0; i < kInverses; ++i) {
    // Mantissas are between 1 and 2; those above 1.5 are treated as 0.75 to 1.
    const double middle = (i < 64 ? 1 : 0.5) * (1 + (i + 0.5) / kInverses);
    if (i < 1 || i == kInverses - 1) continue;
    const double c = static_cast<double>(static_cast<int>(256 / middle + 0.5)) / 256;
    table[i] = {c, Negative(LogBySeries(c - 1))};
  }
  return table;
}();

/// log(1 + z) - z + z^2/2 for |z| < 2^-6.4. Callers add z - z^2/2, in higher precision if they need it.
double LogTail(double z) {
  const double q = z * z * z;
  return q * (1.0 / 3 +
              z * (-1.0 / 4 +
                   z * (1.0 / 5 + z * (-1.0 / 6 + z * (1.0 / 7 + z * (-1.0 / 8 + z * (1.0 / 9 + z * (-1.0 / 10))))))));
}

}  // namespace

Scaled ExpScaled(DoubleDouble x) {
  const double rounded = x.hi * kPowersPerUnit + kRound - kRound;
  const int steps = static_cast<int>(rounded);
  // The product is exact: 17 times 36 bits.
  const DoubleDouble rest = Add(TwoSum(x.hi - rounded * kUnitHi, -(rounded * kUnitLo)), x.lo);
  const double r = rest.hi;
  const double polynomial =
      r * r * (1.0 / 2 + r * (1.0 / 6 + r * (1.0 / 24 + r * (1.0 / 120 + r * (1.0 / 720 + r * (1.0 / 5040))))));
  const DoubleDouble& power = kPowersOfTwo[steps & (kPowers - 1)];
  const DoubleDouble first = TwoProduct(power.hi, r);
  const DoubleDouble sum = FastTwoSum(power.hi, first.hi);
  const double low = power.hi * (polynomial + rest.lo) + (first.lo + power.lo * (1 + r)) + sum.lo;
  return {FastTwoSum(sum.hi, low), steps >> 6};
}

double Scale(const Scaled& scaled) {
  const int exponent = scaled.exponent;
  if (exponent > 1100) return kInfinity;
  if (exponent < -1200) return 0;
  const auto power = [](int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); };
  const double value = scaled.value.hi + scaled.value.lo;
  if (exponent >= -1021 && exponent <= 1022) return value * power(exponent);
  if (exponent > 0) return value * power(1022) * power(exponent - 1022);
  return value * power(exponent + 512) * power(-512);
}

DoubleDouble LogOf(double x, double rest) {
  int exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    rest *= 0x1p54;
    exponent = -54;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  exponent += static_cast<int>(bits >> 52) - 1023;
  const int index = static_cast<int>(bits >> 45) & (kInverses - 1);
  double mantissa = std::bit_cast<double>((bits & 0xfffffffffffffULL) | 0x3ff0000000000000ULL);
  if (index >= 64) {
    mantissa /= 2;
    ++exponent;
  }
  const Inverse& inverse = kInversesOf[index];
  const DoubleDouble product = TwoProduct(mantissa, inverse.c);
  DoubleDouble z = TwoSum(product.hi - 1, product.lo);
  if (rest != 0) z = Add(z, rest / x * product.hi);
  const DoubleDouble square = Multiply(z, z);
  const DoubleDouble series = Add(z, Add({-0.5 * square.hi, -0.5 * square.lo}, LogTail(z.hi)));
  return Add(Add(Multiply(kLn2, exponent), inverse.minus_log), series);
}

double FastLogOf(float x) {
  const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(x));
  int exponent = static_cast<int>(bits >> 52) - 1023;
  const int index = static_cast<int>(bits >> 45) & (kInverses - 1);
  double mantissa = std::bit_cast<double>((bits & 0xfffffffffffffULL) | 0x3ff0000000000000ULL);
  if (index >= 64) {
    mantissa /= 2;
    ++exponent;
  }
  const Inverse& inverse = kInversesOf[index];
  const double z = mantissa * inverse.c - 1;  // Exact: 24 times 9 bits.
  return (exponent * kLn2.hi + inverse.minus_log.hi) + (z - 0.5 * z * z + LogTail(z));
}

double Exp(double x) {
  if (!(x > -746 && x < 710)) return x < 0 ? 0.0 : x > 0 ? kInfinity : x;
  if (std::abs(x) < 0x1p-54) return 1 + x;
  return Scale(ExpScaled({x, 0}));
}

double Log(double x) {
  if (!(x > 0 && x < kInfinity)) return x == 0 ? -kInfinity : x < 0 ? kNan : x;
  const DoubleDouble log = LogOf(x);
  return log.hi + log.lo;
}

double Log2(double x) {
  if (!(x > 0 && x < kInfinity)) return Log(x);
  int exponent = 0;
  if (std::frexp(x, &exponent) == 0.5) return exponent - 1;
  const DoubleDouble log = Multiply(LogOf(x), kReciprocalOfLn2);
  return log.hi + log.lo;
}

double Log10(double x) {
  if (!(x > 0 && x < kInfinity)) return Log(x);
  const DoubleDouble log = Multiply(LogOf(x), kReciprocalOfLn10);
  return log.hi + log.lo;
}

double Log1p(double x) {
  if (!(x > -1 && x < 0x1p60)) return x == -1 ? -kInfinity : x < -1 ? kNan : Log(x);
  if (std::abs(x) < 0x1p-54) return x;
  if (std::abs(x) < 0x1p-7) {
    const DoubleDouble square = TwoProduct(x, x);
    const DoubleDouble log = Add(Add(DoubleDouble{-0.5 * square.hi, -0.5 * square.lo}, LogTail(x)), x);
    return log.hi + log.lo;
  }
  const DoubleDouble sum = TwoSum(1, x);
  const DoubleDouble log = LogOf(sum.hi, sum.lo);
  return log.hi + log.lo;
}

double Pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  const bool whole = std::abs(y) >= 0x1p53 || std::floor(y) == y;
  const bool odd = whole && std::abs(y) < 0x1p53 && std::fmod(y, 2) != 0;
  const double sign = odd && std::signbit(x) ? -1 : 1;
  const double base = std::abs(x);
  if (base == 0) return y > 0 ? sign * 0.0 : sign * kInfinity;
  if (std::isinf(y)) return base == 1 ? 1 : (base > 1) == (y > 0) ? kInfinity : 0;
  if (std::isinf(x)) return y > 0 ? sign * kInfinity : sign * 0.0;
  if (x < 0 && !whole) return kNan;
  if (base == 1) return sign;
  if (y == 1) return x;
  if (y == 2) return x * x;
  if (y == 0.5) return std::sqrt(base);
  const DoubleDouble log = LogOf(base);
  const double estimate = log.hi * y;
  if (estimate > 710) return sign * kInfinity;
  if (estimate < -746) return sign * 0.0;
  if (std::abs(estimate) < 0x1p-60) return sign * (1 + estimate);
  return sign * Scale(ExpScaled(Multiply(log, y)));
}

double Sinh(double x) {
  const double size = std::abs(x);
  if (!(size < 711)) return x;
  if (size < 0.05) {
    const double square = x * x;
    return x + x * square * (1.0 / 6 + square * (1.0 / 120 + square * (1.0 / 5040 + square * (1.0 / 362880))));
  }
  Scaled e = ExpScaled({size, 0});
  if (size < 40) {
    const auto power = [](int n) { return std::ldexp(1.0, n); };
    const DoubleDouble grown{e.value.hi * power(e.exponent), e.value.lo * power(e.exponent)};
    e = {Add(grown, Negative(Divide({1, 0}, grown))), 0};
  }
  --e.exponent;
  return std::copysign(Scale(e), x);
}

double Cosh(double x) {
  const double size = std::abs(x);
  if (!(size < 711)) return size;
  Scaled e = ExpScaled({size, 0});
  if (size < 40) {
    const DoubleDouble grown{std::ldexp(e.value.hi, e.exponent), std::ldexp(e.value.lo, e.exponent)};
    e = {Add(grown, Divide({1, 0}, grown)), 0};
  }
  --e.exponent;
  return Scale(e);
}

double Tanh(double x) {
  const double size = std::abs(x);
  if (std::isnan(x)) return x;
  if (size > 22) return std::copysign(1.0, x);
  if (size < 0x1p-27) return x;
  if (size < 0.05) {
    // The quotient of the series of sinh and cosh.
    const double square = x * x;
    const double sine = x * square * (1.0 / 6 + square * (1.0 / 120 + square * (1.0 / 5040 + square * (1.0 / 362880))));
    const double cosine = square * (1.0 / 2 + square * (1.0 / 24 + square * (1.0 / 720 + square * (1.0 / 40320))));
    const DoubleDouble quotient = Divide(FastTwoSum(x, sine), FastTwoSum(1, cosine));
    return quotient.hi + quotient.lo;
  }
  const Scaled e = ExpScaled({2 * size, 0});
  const DoubleDouble grown{std::ldexp(e.value.hi, e.exponent), std::ldexp(e.value.lo, e.exponent)};
  const DoubleDouble quotient = Divide(Add(grown, -1.0), Add(grown, 1.0));
  return std::copysign(quotient.hi + quotient.lo, x);
}

}  // namespace soarbox::numerics
