// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "numerics/double_double.h"

namespace soarbox::numerics {

/// x = quadrants * pi/2 + angle, with |angle| at most a little above pi/4. Only the last two bits of `quadrants` count.
struct Reduced {
  DoubleDouble angle;
  int quadrants = 0;
};

/// For any finite x, with an error of the angle below 2^-100 (and below 2^-66 of its size).
Reduced Reduce(double x);

/// The same in double precision: an error below 2^-50 for what a float can be.
struct FastReduced {
  double angle = 0;
  int quadrants = 0;
};
FastReduced FastReduce(float x);

}  // namespace soarbox::numerics
