// SPDX-License-Identifier: BSD-2-Clause
//
// Subtracts multiples of pi/2 from angles. For small angles, with parts of pi/2 whose products with the multiple are
// exact (Cody and Waite); for large ones, with those bits of 2/pi that matter for the exponent (Payne and Hanek).
#include "numerics/reduction.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace soarbox::numerics {
namespace {

constexpr double kTwoOverPi = 0x1.45f306dc9c883p-1;
constexpr double kRound = 0x1.8p52;
constexpr DoubleDouble kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
// pi/2 in parts of 33, 33 and 53 bits.
constexpr double kFirst = 0x1.921fb544p+0;
constexpr double kSecond = 0x1.0b4611a6p-34;
constexpr double kThird = 0x1.3198a2e037073p-69;
// Multiples of fewer than 20 bits have exact products with the first two parts.
constexpr double kLargestSmall = 1e6;

// The bits of 2/pi after the binary point.
constexpr std::uint64_t kBits[] = {0xa2f9836e4e441529, 0xfc2757d1f534ddc0, 0xdb6295993c439041, 0xfe5163abdebbc561,
                                   0xb7246e3a424dd2e0, 0x06492eea09d1921c, 0xfe1deb1cb129a73e, 0xe88235f52ebb4484,
                                   0xe99c7026b45f7e41, 0x3991d639835339f4, 0x9c845f8bbdf9283b, 0x1ff897ffde05980f,
                                   0xef2f118b5a0a6d1f, 0x6d367ecf27cb09b7, 0x4f463f669e5fea2d, 0x7527bac7ebe5f17b,
                                   0x3d0739f78a5292ea, 0x6bfb5fb11f8d5d08, 0x56033046fc7b6bab, 0xf0cfbc209af4361d};

/// 64 bits of 2/pi, beginning at bit `first` after the binary point; bits before the point are zero.
std::uint64_t BitsFrom(int first) {
  if (first <= -64) return 0;
  if (first < 0) return kBits[0] >> -first;
  const int word = first / 64, shift = first % 64;
  return shift == 0 ? kBits[word] : (kBits[word] << shift) | (kBits[word + 1] >> (64 - shift));
}

Reduced ReduceLarge(double size) {
  __extension__ typedef unsigned __int128 Wide;
  const auto bits = std::bit_cast<std::uint64_t>(size);
  const std::uint64_t mantissa = (bits & 0xfffffffffffffULL) | 0x10000000000000ULL;
  // size = mantissa * 2^exponent. Bits of 2/pi that give multiples of four are not needed.
  const int exponent = static_cast<int>(bits >> 52) - 1075;
  const int first = exponent - 2;
  // mantissa * (192 bits of 2/pi), modulo 4: 256 bits, of which the upper 64 are dropped.
  const Wide low = static_cast<Wide>(mantissa) * BitsFrom(first + 128);
  const Wide middle = static_cast<Wide>(mantissa) * BitsFrom(first + 64) + (low >> 64);
  const std::uint64_t high = mantissa * BitsFrom(first) + static_cast<std::uint64_t>(middle >> 64);
  // The value modulo 4 is high.middle.low with two bits before the binary point.
  int quadrants = static_cast<int>(high >> 62);
  Wide fraction = (static_cast<Wide>(high << 2 | static_cast<std::uint64_t>(middle) >> 62) << 64) |
                  (static_cast<std::uint64_t>(middle) << 2 | static_cast<std::uint64_t>(low) >> 62);
  const std::uint64_t below = static_cast<std::uint64_t>(low) << 2;
  bool negative = false;
  if (fraction >> 127) {
    ++quadrants;
    fraction = ~fraction;  // Too small by 2^-128, which is below the error.
    negative = true;
  }
  // Splits the leading 160 bits into five doubles of 32 bits each, which are exact.
  double value = 0, rest = 0;
  const auto upper = static_cast<std::uint64_t>(fraction >> 64), lower = static_cast<std::uint64_t>(fraction);
  const double parts[] = {static_cast<double>(upper >> 32) * 0x1p-32, static_cast<double>(upper & 0xffffffff) * 0x1p-64,
                          static_cast<double>(lower >> 32) * 0x1p-96,
                          static_cast<double>(lower & 0xffffffff) * 0x1p-128,
                          static_cast<double>((negative ? ~below : below) >> 32) * 0x1p-160};
  DoubleDouble sum;
  for (const double part : parts) sum = Add(sum, part);
  value = negative ? -sum.hi : sum.hi;
  rest = negative ? -sum.lo : sum.lo;
  return {Multiply({value, rest}, kHalfPi), quadrants};
}

}  // namespace

Reduced Reduce(double x) {
  if (std::abs(x) <= 0.785) return {{x, 0}, 0};
  if (std::abs(x) < kLargestSmall) {
    const double multiple = x * kTwoOverPi + kRound - kRound;
    const DoubleDouble first = TwoSum(x - multiple * kFirst, -(multiple * kSecond));
    const DoubleDouble third = TwoProduct(multiple, kThird);
    return {Add(first, Negative(third)), static_cast<int>(multiple)};
  }
  Reduced reduced = ReduceLarge(std::abs(x));
  if (x < 0) reduced = {Negative(reduced.angle), -reduced.quadrants};
  return reduced;
}

FastReduced FastReduce(float x) {
  const double value = x;
  if (std::abs(value) <= 0.785) return {value, 0};
  if (std::abs(value) < kLargestSmall) {
    const double multiple = value * kTwoOverPi + kRound - kRound;
    return {(value - multiple * kFirst) - multiple * kSecond, static_cast<int>(multiple)};
  }
  const Reduced reduced = Reduce(value);
  return {reduced.angle.hi, reduced.quadrants};
}

}  // namespace soarbox::numerics
