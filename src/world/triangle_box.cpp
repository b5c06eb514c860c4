// SPDX-License-Identifier: BSD-2-Clause
#include "world/triangle_box.h"

#include <algorithm>
#include <cmath>

namespace soarbox::world {
namespace {

/// Whether the projections on the axis do not overlap.
bool Separates(Vec3 axis, const std::array<Vec3, 3>& corners, Vec3 half) {
  const float a = Dot(axis, corners[0]), b = Dot(axis, corners[1]), c = Dot(axis, corners[2]);
  const float reach = half.x * std::abs(axis.x) + half.y * std::abs(axis.y) + half.z * std::abs(axis.z);
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

}  // namespace

bool TriangleTouchesBox(const std::array<Vec3, 3>& triangle, Vec3 center, Vec3 half) {
  const std::array<Vec3, 3> corners{triangle[0] - center, triangle[1] - center, triangle[2] - center};
  constexpr Vec3 kAxes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::array<Vec3, 3> edges{corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
  for (const Vec3 axis : kAxes) {
    if (Separates(axis, corners, half)) return false;
    for (const Vec3 edge : edges) {
      if (Separates(Cross(axis, edge), corners, half)) return false;
    }
  }
  return !Separates(Cross(edges[0], edges[1]), corners, half);
}

}  // namespace soarbox::world
