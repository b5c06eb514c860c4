// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soarbox::sweep {

/// Points of a cube whose sides are 0 to 1 (1 excluded), for parameters that are drawn from ranges: a row for each
/// point, a number for each side. The same seed gives the same points on each machine.
using Points = std::vector<std::vector<double>>;

/// Independent points. The first ones stay the same if there are more.
Points RandomPoints(std::size_t count, std::size_t sides, std::uint64_t seed);

/// A Latin hypercube: each side is cut into `count` equal parts, and each part holds exactly one point. All points
/// change with their number.
Points LatinPoints(std::size_t count, std::size_t sides, std::uint64_t seed);

}  // namespace soarbox::sweep
