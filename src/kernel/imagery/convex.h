// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>

#include "kernel/imagery/space.h"

namespace soarbox::kernel::imagery {

/// A convex body in world coordinates: all points within `margin` of its core. The core is the convex hull of some
/// points, or an ellipsoid. (A ball is one point with a margin.) Refers to the points and the transform, which must
/// outlive it.
struct Solid {
  std::span<const Vec3> points;
  const Transform* ellipsoid = nullptr;  ///< If not null: maps the ball of `radius` around 0 to the core.
  double radius = 0;
  double margin = 0;

  /// The point of the core that is farthest in this direction.
  Vec3 Support(const Vec3& direction) const;
};

/// The distance between two solids, 0 if they touch or overlap. For polyhedra and balls it is exact except for
/// rounding; for ellipsoids, to about 1e-9 of their size. (Gilbert, Johnson and Keerthi's algorithm, as van den Bergen
/// describes it.)
double DistanceBetween(const Solid& a, const Solid& b);

/// Finds the two closest points, one on each solid. Returns false if the solids touch or overlap.
bool ShortestBetween(const Solid& a, const Solid& b, Vec3& from, Vec3& to);

/// Whether the point is inside a solid. (The outermost 0.02 % of a ball count as outside.)
bool HasPoint(const Solid& solid, const Vec3& point);

}  // namespace soarbox::kernel::imagery
