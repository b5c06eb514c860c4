// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "world/math.h"
#include "world/navigation_config.h"
#include "world/navigation_geometry.h"
#include "world/world_random.h"

namespace soarbox::world {

/// Where agents can walk, as convex polygons, and the paths between them. Built once from fixed geometry (Recast) and
/// then queried (Detour). Later changes of the geometry have no effect.
///
/// Points on the mesh are about half a cell above the true floor. Deterministic: the same geometry and configuration
/// give the same mesh and the same answers. Queries are not thread-safe.
class NavigationMesh {
 public:
  /// Geometry beyond this distance from the origin, on any axis, is ignored.
  static constexpr float kHalfExtent_m = 100.05f;
  /// Limits for the source of one mesh: number of triangles, and number of cells that the sides of the triangles cover.
  static constexpr std::size_t kMaxTriangles = 400'000;
  static constexpr double kMaxCoveredCells = 20e6;

  /// Fails if the configuration is invalid, or if the mesh would be too large. Fast.
  static Result<void> Check(const NavigationGeometry& geometry, const NavigationConfig& config);
  /// Approximate number of cells that the geometry covers, which determines the cost of Build.
  static double CoveredCells(const NavigationGeometry& geometry, const NavigationConfig& config);
  /// May take a second. Can be called on any thread. Fails if nothing is walkable.
  static Result<std::unique_ptr<NavigationMesh>> Build(const NavigationGeometry& geometry,
                                                       const NavigationConfig& config);
  ~NavigationMesh();

  /// The shortest path, with a point at each crossing of an edge. Both ends are on the mesh. Empty if there is no path,
  /// or if an end is more than (2, 5, 2) m from the mesh.
  std::vector<Vec3> FindPath(Vec3 from, Vec3 to) const;
  /// False if the mesh shows that no agent at `from` can walk to within within_m of `to`, measured horizontally. True
  /// if that is not certain: there is no mesh at `from`, or `to` is beyond its edges.
  bool MayReach(Vec3 from, Vec3 to, float within_m) const;
  /// The nearest point of the mesh within (0.5, 2, 0.5) m; the argument if there is none, or if
  /// NavigationConfig::keeps_points is set.
  Vec3 FindClosestPoint(Vec3 point) const;
  /// A random point of the mesh, uniformly distributed by horizontal area. Draws three numbers from the stream.
  Vec3 RandomPoint(RandomStream& random) const;

  /// All polygons of the mesh. Each is a triangle.
  const std::vector<std::array<Vec3, 3>>& triangles() const;
  Vec3 min() const;
  Vec3 max() const;
  float area_m2() const;

 private:
  struct Impl;
  explicit NavigationMesh(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::world
