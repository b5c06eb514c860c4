// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "kernel/imagery/space.h"

namespace soarbox::kernel::imagery {

/// A convex body in the world: everything within `margin` of the hull of some points or of an ellipsoid (so a ball is
/// one point with a margin). It refers to the points and the transform, which must outlive it.
struct Solid {
  std::span<const Vec3> points;
  const Transform* ellipsoid = nullptr;  ///< Of a ball of `radius` about 0, instead of points.
  double radius = 0;
  double margin = 0;

  /// The point of the core that is farthest in this direction.
  Vec3 Support(const Vec3& direction) const;
};

/// The distance between two solids, 0 if they touch or overlap. For polyhedra and balls it is exact except for
/// rounding; for ellipsoids, to about 1e-9 of their size. (Gilbert, Johnson and Keerthi's algorithm, as van den Bergen
/// describes it.)
double DistanceBetween(const Solid& a, const Solid& b);

/// The points at which two solids are nearest to each other, one on each. False if they touch or overlap.
bool ShortestBetween(const Solid& a, const Solid& b, Vec3& from, Vec3& to);

/// Whether the point is inside a solid. (The outermost 0.02 % of a ball count as outside.)
bool HasPoint(const Solid& solid, const Vec3& point);

}  // namespace soarbox::kernel::imagery
