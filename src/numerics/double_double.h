// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::numerics {

/// An unevaluated sum of two doubles, `hi + lo`, with |lo| at most half a unit in the last place of `hi`: about 106
/// bits.
///
/// Only additions, subtractions, multiplications and divisions of IEEE 754 doubles are used, so that the bits are the
/// same on every processor. The code must be compiled without fused multiply-add (-ffp-contract=off). Source: T. J.
/// Dekker, "A floating-point technique for extending the available precision", 1971.
struct DoubleDouble {
  double hi = 0;
  double lo = 0;
};

/// a + b without error.
constexpr DoubleDouble TwoSum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

/// a + b without error if |a| >= |b| or a is 0.
constexpr DoubleDouble FastTwoSum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a * b without error, unless a part overflows (above 2^996) or underflows.
constexpr DoubleDouble TwoProduct(double a, double b) {
  constexpr double kSplit = 134217729;  // 2^27 + 1
  const double a_scaled = kSplit * a, b_scaled = kSplit * b;
  const double a_hi = a_scaled - (a_scaled - a), b_hi = b_scaled - (b_scaled - b);
  const double a_lo = a - a_hi, b_lo = b - b_hi;
  const double product = a * b;
  return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

constexpr DoubleDouble Negative(DoubleDouble a) {
  return {-a.hi, -a.lo};
}

constexpr DoubleDouble Add(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble high = TwoSum(a.hi, b.hi);
  const DoubleDouble low = TwoSum(a.lo, b.lo);
  const DoubleDouble sum = FastTwoSum(high.hi, high.lo + low.hi);
  return FastTwoSum(sum.hi, sum.lo + low.lo);
}

constexpr DoubleDouble Add(DoubleDouble a, double b) {
  const DoubleDouble sum = TwoSum(a.hi, b);
  return FastTwoSum(sum.hi, sum.lo + a.lo);
}

constexpr DoubleDouble Multiply(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble product = TwoProduct(a.hi, b.hi);
  return FastTwoSum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

constexpr DoubleDouble Multiply(DoubleDouble a, double b) {
  const DoubleDouble product = TwoProduct(a.hi, b);
  return FastTwoSum(product.hi, product.lo + a.lo * b);
}

constexpr DoubleDouble Divide(DoubleDouble a, DoubleDouble b) {
  const double first = a.hi / b.hi;
  const DoubleDouble rest = Add(a, Negative(Multiply(b, first)));
  const double second = rest.hi / b.hi;
  const DoubleDouble rest_of_rest = Add(rest, Negative(Multiply(b, second)));
  const DoubleDouble quotient = FastTwoSum(first, second);
  return FastTwoSum(quotient.hi, quotient.lo + rest_of_rest.hi / b.hi);
}

}  // namespace soarbox::numerics
