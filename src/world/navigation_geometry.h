// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "world/math.h"

namespace soarbox::world {

/// The triangles from which a navigation mesh is built, in world coordinates. Seen from its outer side, the corners of
/// a triangle are counterclockwise.
struct NavigationGeometry {
  std::vector<float> vertices;  ///< x, y, z of each vertex.
  std::vector<int> triangles;   ///< Three vertex indices each.

  bool empty() const { return triangles.empty(); }
  /// Adds a box with these half extents around `center`, in its own coordinates.
  void AddBox(Vec3 center, Vec3 half, Vec3 position, Quat orientation);
  /// Adds a capsule, upright in its own coordinates; the height includes the caps.
  void AddCapsule(float radius_m, float height_m, Vec3 position, Quat orientation);
  void Bounds(Vec3& min, Vec3& max) const;
  std::uint64_t Hash() const;

 private:
  int AddVertex(Vec3 v);
  void AddTriangle(int a, int b, int c);
};

}  // namespace soarbox::world
