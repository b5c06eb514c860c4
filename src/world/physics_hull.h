// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "world/math.h"

namespace soarbox::world {

/// A convex polyhedron as edges and faces, which are indices of `points`.
struct ConvexHull {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< Each edge once; edges between two coplanar faces are omitted.
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< Triangles. A flat hull has both sides; a line has none.
};

/// The convex hull of some points. The hull of one point is the point; the hull of points on a line is the line.
/// Ignores points that are not finite.
ConvexHull HullAround(std::span<const Vec3> points);

}  // namespace soarbox::world
