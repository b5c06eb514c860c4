// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "world/math.h"

namespace soarbox::world {

/// A convex body as wire and skin. Numbers count `points` from 0.
struct ConvexHull {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< Each once; none between two faces that lie in one plane.
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< Triangles; of a flat body both sides, of a line none.
};

/// The convex hull of some points. Of one point: itself; of points on a line: that line. Points that are not finite
/// are left out.
ConvexHull HullAround(std::span<const Vec3> points);

}  // namespace soarbox::world
