// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "world/math.h"

namespace soarbox::world {

/// The triangles that a navigation mesh is made from, in world space: the outer side of each is the one that sees its
/// corners counterclockwise.
struct NavigationGeometry {
  std::vector<float> vertices;  ///< x, y, z of each.
  std::vector<int> triangles;   ///< Three indices of vertices each.

  bool empty() const { return triangles.empty(); }
  /// A box of these half extents around its own centre.
  void AddBox(Vec3 center, Vec3 half, Vec3 position, Quat orientation);
  /// Upright in its own space; the height includes the caps.
  void AddCapsule(float radius_m, float height_m, Vec3 position, Quat orientation);
  void Bounds(Vec3& min, Vec3& max) const;
  std::uint64_t Hash() const;

 private:
  int AddVertex(Vec3 v);
  void AddTriangle(int a, int b, int c);
};

}  // namespace soarbox::world
