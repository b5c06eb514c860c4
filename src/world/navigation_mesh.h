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
#include "world/random.h"

namespace soarbox::world {

/// Where agents can walk, as convex polygons, and the ways between them: made once from fixed geometry (Recast), asked
/// many times (Detour). Later changes of the geometry do not reach it.
///
/// Points on the mesh lie about half a cell above the true floor. Deterministic: the same geometry and configuration
/// give the same mesh and the same answers. Queries are for one thread at a time.
class NavigationMesh {
 public:
  /// Geometry beyond this distance from the origin, on any axis, is left out.
  static constexpr float kHalfExtent_m = 100.05f;
  /// Limits of what one mesh is made from: triangles, and cells that the sides of the triangles cover.
  static constexpr std::size_t kMaxTriangles = 400'000;
  static constexpr double kMaxCoveredCells = 20e6;

  /// Says what is wrong with a configuration, or that this geometry asks for too large a mesh; fast.
  static Result<void> Check(const NavigationGeometry& geometry, const NavigationConfig& config);
  /// How many cells the geometry covers, roughly: the cost of Build.
  static double CoveredCells(const NavigationGeometry& geometry, const NavigationConfig& config);
  /// May take a second; safe on any thread. An error if nothing is walkable.
  static Result<std::unique_ptr<NavigationMesh>> Build(const NavigationGeometry& geometry,
                                                       const NavigationConfig& config);
  ~NavigationMesh();

  /// The shortest way, with a point at each crossing of an edge, both ends on the mesh; empty if an end is further than
  /// (2, 5, 2) m from the mesh or there is no way.
  std::vector<Vec3> FindPath(Vec3 from, Vec3 to) const;
  /// False if the mesh shows that nobody at `from` can walk to within this distance of `to`, measured on the map:
  /// nothing that is connected to the mesh at `from` comes so near. True where it cannot tell: no mesh at `from`, or
  /// `to` beyond its edges.
  bool MayReach(Vec3 from, Vec3 to, float within_m) const;
  /// The nearest point of the mesh within (0.5, 2, 0.5) m; the point itself if there is none.
  Vec3 FindClosestPoint(Vec3 point) const;
  /// Each place is equally likely, measured on the map; takes three numbers off the stream.
  Vec3 RandomPoint(RandomStream& random) const;

  /// All polygons; they are triangles.
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
