// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <limits>

#include "world/physics_hull.h"

namespace soarbox::world {
namespace {

TEST(ConvexHull, OfABoxHasItsEightCornersTwelveEdgesAndTwelveTriangles) {
  std::vector<Vec3> points{{0.5f, 0.5f, 0.5f}, {0.1f, 0.9f, 0.4f}};  // Inside the hull.
  for (int corner = 0; corner < 8; ++corner)
    points.push_back({corner & 1 ? 1.0f : 0.0f, corner & 2 ? 1.0f : 0.0f, corner & 4 ? 1.0f : 0.0f});
  const ConvexHull hull = HullAround(points);
  EXPECT_EQ(hull.points.size(), 8u);
  EXPECT_EQ(hull.edges.size(), 12u);
  EXPECT_EQ(hull.faces.size(), 12u);
}

TEST(ConvexHull, OfFewPointsIsWhatTheySpan) {
  EXPECT_TRUE(HullAround({}).points.empty());
  const std::vector<Vec3> one{{1, 2, 3}}, line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, flat{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(HullAround(one).points.size(), 1u);
  EXPECT_TRUE(HullAround(one).edges.empty());
  const ConvexHull segment = HullAround(line);
  EXPECT_EQ(segment.points.size(), 2u);
  EXPECT_EQ(segment.edges.size(), 1u);
  EXPECT_TRUE(segment.faces.empty());
  const ConvexHull triangle = HullAround(flat);
  EXPECT_EQ(triangle.points.size(), 3u);
  EXPECT_EQ(triangle.edges.size(), 3u);
  EXPECT_EQ(triangle.faces.size(), 2u);
}

TEST(ConvexHull, LeavesOutWhatIsNowhere) {
  const float nowhere = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Vec3> points{{nowhere, 0, 0}, {0, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(HullAround(points).points.size(), 2u);
}

}  // namespace
}  // namespace soarbox::world
