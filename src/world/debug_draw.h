// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::world {

/// Lines that last for one tick: BeginTick clears them (spec 13). Colours are 0..1 per channel. Shapes with values that
/// are not finite are ignored.
class DebugDraw {
 public:
  void Line(Vec3 from, Vec3 to, Vec3 color);
  /// Horizontal, of 10 segments; ignored if radius_m <= 0.
  void Circle(Vec3 center, float radius_m, Vec3 color);
  /// Wire sphere; filled adds translucent triangles. Ignored if radius_m <= 0.
  void Sphere(Vec3 center, float radius_m, Vec3 color, bool filled = false);
  /// Horizontal; side is the full length.
  void Square(Vec3 center, float side_m, Vec3 color, bool filled = false);
  void Clear();

  /// Of lines and triangles.
  std::size_t size() const { return line_count_ + triangles_.size(); }
  /// In the order of the calls.
  void AppendLines(std::vector<LineSnapshot>& lines) const;
  const std::vector<TriangleSnapshot>& triangles() const { return triangles_; }

 private:
  void Triangle(Vec3 a, Vec3 b, Vec3 c, Vec3 color);

  /// Lines and circles; who draws them is the first to make lines of a circle.
  struct Shape {
    Vec3 from;  ///< Of a circle: its centre.
    Vec3 to;    ///< Of a circle: its radius in x.
    Vec3 color;
    bool is_circle = false;
  };

  std::vector<Shape> shapes_;
  std::size_t line_count_ = 0;
  std::vector<TriangleSnapshot> triangles_;
};

}  // namespace soarbox::world
