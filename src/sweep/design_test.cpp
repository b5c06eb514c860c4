// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/design.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

namespace soarbox::sweep {
namespace {

TEST(Design, EachPartOfEachSideOfALatinHypercubeHoldsOnePoint) {
  for (const std::size_t count : {1u, 2u, 7u, 100u}) {
    const Points points = LatinPoints(count, 4, 3);
    ASSERT_EQ(points.size(), count);
    for (std::size_t side = 0; side < 4; ++side) {
      std::set<std::size_t> parts;
      for (const std::vector<double>& point : points) {
        ASSERT_GE(point[side], 0);
        ASSERT_LT(point[side], 1);
        parts.insert(static_cast<std::size_t>(point[side] * static_cast<double>(count)));
      }
      EXPECT_EQ(parts.size(), count) << "side " << side;
    }
  }
}

TEST(Design, TheSidesOfALatinHypercubeAreIndependent) {
  const Points points = LatinPoints(1000, 2, 1);
  double sum = 0;
  for (const std::vector<double>& point : points) sum += (point[0] - 0.5) * (point[1] - 0.5);
  // The correlation of two uniform dimensions with 1,000 points has a standard deviation of 0.032.
  EXPECT_LT(std::abs(sum / 1000 * 12), 0.1);
}

TEST(Design, ASeedGivesItsPointsAgainAndRandomOnesStayIfThereAreMore) {
  EXPECT_EQ(LatinPoints(20, 3, 5), LatinPoints(20, 3, 5));
  EXPECT_NE(LatinPoints(20, 3, 5), LatinPoints(20, 3, 6));
  const Points few = RandomPoints(10, 3, 5), more = RandomPoints(30, 3, 5);
  EXPECT_TRUE(std::ranges::equal(few, std::span(more).first(10)));
  double mean = 0;
  for (const std::vector<double>& point : RandomPoints(1000, 1, 1)) mean += point[0] / 1000;
  EXPECT_NEAR(mean, 0.5, 0.03);
}

}  // namespace
}  // namespace soarbox::sweep
