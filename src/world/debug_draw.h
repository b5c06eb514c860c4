// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::world {

/// Lines and shapes that scripts draw for one tick (lua_api.md 13). BeginTick removes them. Colours are 0..1 per
/// channel. Shapes with values that are not finite are ignored.
class DebugDraw {
 public:
  void Line(Vec3 from, Vec3 to, Vec3 color);
  /// Horizontal. Ignored if radius_m <= 0.
  void Circle(Vec3 center, float radius_m, Vec3 color);
  /// A wireframe sphere; `filled` adds translucent triangles. Ignored if radius_m <= 0.
  void Sphere(Vec3 center, float radius_m, Vec3 color, bool filled = false);
  /// Horizontal; side_m is the full length.
  void Square(Vec3 center, float side_m, Vec3 color, bool filled = false);
  void Clear();

  /// Number of lines and triangles.
  std::size_t size() const { return lines_.size() + kLinesOfCircle * circles_.size() + triangles_.size(); }
  const std::vector<LineSnapshot>& lines() const { return lines_; }
  const std::vector<CircleSnapshot>& circles() const { return circles_; }
  const std::vector<TriangleSnapshot>& triangles() const { return triangles_; }

 private:
  void Triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 color);

  std::vector<LineSnapshot> lines_;
  std::vector<CircleSnapshot> circles_;
  std::vector<TriangleSnapshot> triangles_;
};

}  // namespace soarbox::world
