// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "numerics/double_double.h"

namespace soarbox::numerics {

/// A value times 2^exponent.
struct Scaled {
  DoubleDouble value;  ///< From 0.9 to 2.1.
  int exponent = 0;
};

/// e^(x.hi + x.lo) with a relative error below 2^-66, for |x| < 2000.
Scaled ExpScaled(DoubleDouble x);

/// The natural logarithm of a positive, finite x, including subnormal numbers, with a relative error below 2^-64.
/// `rest` is added to x and must be below 2^-52 of it.
DoubleDouble LogOf(double x, double rest = 0);

/// The same for a positive, finite float, as a double with a relative error below 2^-48.
double FastLogOf(float x);

/// value * 2^exponent, rounded once if the result is a normal number.
double Scale(const Scaled& scaled);

}  // namespace soarbox::numerics
