// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soarbox::sweep {

/// Points in a unit cube (1 excluded), for parameters that are drawn from ranges: a row for each point, a number for
/// each dimension. The same seed gives the same points on all machines.
using Points = std::vector<std::vector<double>>;

/// Independent points. A larger `count` keeps the first points.
Points RandomPoints(std::size_t count, std::size_t sides, std::uint64_t seed);

/// A Latin hypercube: each dimension is split into `count` equal intervals, and each interval contains exactly one
/// point. A different `count` changes all points.
Points LatinPoints(std::size_t count, std::size_t sides, std::uint64_t seed);

}  // namespace soarbox::sweep
