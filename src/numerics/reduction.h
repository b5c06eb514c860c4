// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "numerics/double_double.h"

namespace soarbox::numerics {

/// x = quadrants * pi/2 + angle, with |angle| slightly above pi/4 at most. Only the last two bits of `quadrants` are
/// valid.
struct Reduced {
  DoubleDouble angle;
  int quadrants = 0;
};

/// Accepts any finite x. The error of the angle is below 2^-100 (and below 2^-66 relative to it).
Reduced Reduce(double x);

/// The same in double precision for a float, with an error below 2^-50.
struct FastReduced {
  double angle = 0;
  int quadrants = 0;
};
FastReduced FastReduce(float x);

}  // namespace soarbox::numerics
