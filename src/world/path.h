// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <vector>

#include "world/math.h"

namespace soarbox::world {

/// A polyline to walk along, with a tube around it. It may have any number of points, also repeated ones. A cyclic path
/// appends a copy of its first point.
class Path {
 public:
  Path() = default;
  Path(std::span<const Vec3> points, bool cyclic, float radius_m);

  bool empty() const { return points_.empty(); }
  bool cyclic() const { return cyclic_; }
  float radius_m() const { return radius_m_; }
  /// A cyclic path of n points returns n + 1 points.
  std::span<const Vec3> points() const { return points_; }
  float length_m() const { return points_.empty() ? 0.0f : distances_.back(); }

  struct Nearest {
    Vec3 point;
    float distance_along_m = 0;  ///< Arc length from the start to `point`.
  };
  /// The nearest point of the polyline. If two segments are equally near, the earlier one is used. An empty path
  /// returns the query.
  Nearest NearestTo(Vec3 query) const;

  /// The point at an arc length, which is clamped to the ends of an open path and taken modulo the length of a cyclic
  /// one. An empty path returns the origin.
  Vec3 PointAt(float distance_along_m) const;

 private:
  std::vector<Vec3> points_;
  std::vector<float> distances_;  ///< Arc length at each point.
  bool cyclic_ = false;
  float radius_m_ = 0;
};

}  // namespace soarbox::world
