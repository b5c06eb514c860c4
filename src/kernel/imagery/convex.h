// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "kernel/imagery/space.h"

namespace soarbox::kernel::imagery {

/// A convex body in the world: the hull of some points, or an ellipsoid, and everything within `margin` of it (so that
/// a ball is one point with a margin). It refers to the points and the transform, which must outlive it.
struct Solid {
  std::span<const Vec3> points;
  const Transform* ellipsoid = nullptr;  ///< Of a ball of `radius` about 0, instead of points.
  double radius = 0;
  double margin = 0;

  /// The point of the core that is farthest in a direction.
  Vec3 Support(const Vec3& direction) const;
};

/// The distance between two solids, 0 if they touch or overlap. Exact for polyhedra and balls but for rounding; to
/// about 1e-9 of their size for ellipsoids. (Gilbert, Johnson and Keerthi's algorithm, as van den Bergen describes it.)
double DistanceBetween(const Solid& a, const Solid& b);

/// Where two solids are nearest to each other: a point of each. False if they touch or overlap.
bool ShortestBetween(const Solid& a, const Solid& b, Vec3& from, Vec3& to);

/// Whether a solid has the point. (Of a ball, the outermost 0.02 % count as outside.)
bool HasPoint(const Solid& solid, const Vec3& point);

}  // namespace soarbox::kernel::imagery
