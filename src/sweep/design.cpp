// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/design.h"

#include <numeric>
#include <utility>

namespace soarbox::sweep {
namespace {

/// Our own generator, because the standard library's distributions differ between implementations.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed) {}
  /// A number from 0 to 1 (excluded).
  double Share() { return static_cast<double>(Next() >> 11) * 0x1p-53; }
  /// 0 to bound - 1.
  std::size_t Below(std::size_t bound) { return static_cast<std::size_t>(Share() * static_cast<double>(bound)); }

 private:
  std::uint64_t Next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
    return mixed ^ (mixed >> 31);
  }
  std::uint64_t state_;
};

}  // namespace

Points RandomPoints(std::size_t count, std::size_t sides, std::uint64_t seed) {
  Draws draws(seed);
  Points points(count, std::vector<double>(sides));
  for (std::vector<double>& point : points)
    for (double& value : point) value = draws.Share();
  return points;
}

Points LatinPoints(std::size_t count, std::size_t sides, std::uint64_t seed) {
  Draws draws(seed);
  Points points(count, std::vector<double>(sides));
  std::vector<std::size_t> parts(count);
  for (std::size_t side = 0; side < sides; ++side) {
    std::iota(parts.begin(), parts.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(parts[i - 1], parts[draws.Below(i)]);
    for (std::size_t i = 0; i < count; ++i)
      points[i][side] = (static_cast<double>(parts[i]) + draws.Share()) / static_cast<double>(count);
  }
  return points;
}

}  // namespace soarbox::sweep
