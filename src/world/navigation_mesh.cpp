// SPDX-License-Identifier: BSD-2-Clause
#include "world/navigation_mesh.h"

#include <DetourAlloc.h>
#include <DetourNavMesh.h>
#include <DetourNavMeshQuery.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "diagnostics/problem.h"
#include "world/navigation_build.h"
#include "world/navigation_files.h"
#include "world/navigation_store.h"
#include "world/rotation.h"

namespace soarbox::world {
namespace {

constexpr int kMaxPathPoints = 4096;
constexpr Vec3 kSnapPath_m{2, 5, 2};
constexpr Vec3 kSnapPoint_m{0.5f, 2, 0.5f};

struct MeshFree {
  void operator()(dtNavMesh* mesh) const { dtFreeNavMesh(mesh); }
};
struct QueryFree {
  void operator()(dtNavMeshQuery* query) const { dtFreeNavMeshQuery(query); }
};

Vec3 FromFloats(const float* v) {
  return {v[0], v[1], v[2]};
}

Diagnostic MeshFault(std::string message, std::string hint) {
  return NewProblem(std::move(message), std::move(hint));
}

std::string Text(float value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

Result<BuiltNavigation> FindOrBuild(const NavigationGeometry& geometry, const NavigationConfig& config) {
  const std::uint64_t source = SourceHash(geometry, config);
  if (std::optional<BuiltNavigation> found = FindSharedNavigation(source)) return std::move(*found);
  if (std::optional<BuiltNavigation> kept = FindKeptNavigation(source)) {
    OfferNavigation(source, *kept);
    return std::move(*kept);
  }
  Result<BuiltNavigation> built = BuildNavigation(geometry, config);
  if (!built.ok()) return built;
  OfferNavigation(source, *built);
  KeepBuiltNavigation(source, *built);
  return built;
}

struct Range {
  const char* name;
  float value, min, max;
};

}  // namespace

struct NavigationMesh::Impl {
  std::unique_ptr<dtNavMesh, MeshFree> mesh{dtAllocNavMesh()};
  std::unique_ptr<dtNavMeshQuery, QueryFree> query{dtAllocNavMeshQuery()};
  dtQueryFilter filter;
  std::vector<std::array<Vec3, 3>> triangles;
  std::vector<std::size_t> islands;  ///< By polygon: number of its connected component.
  std::vector<float> area_sums_m2;   ///< By triangle: horizontal area of it and all triangles before it.
  Vec3 min, max;
  bool keeps_points = false;
  // Reused by all queries.
  std::vector<dtPolyRef> corridor;
  std::vector<dtPolyRef> crossed;
  std::vector<float> points;

  dtPolyRef Nearest(Vec3 point, Vec3 half, float* nearest) const {
    dtPolyRef polygon = 0;
    const float center[3] = {point.x, point.y, point.z}, extents[3] = {half.x, half.y, half.z};
    if (!IsFinite(point) || dtStatusFailed(query->findNearestPoly(center, extents, &filter, &polygon, nearest)))
      return 0;
    return polygon;
  }
  void FindIslands();
  std::size_t IslandOf(dtPolyRef polygon) const { return islands[mesh->decodePolyIdPoly(polygon)]; }
};

void NavigationMesh::Impl::FindIslands() {
  constexpr std::size_t kNone = ~std::size_t{0};
  const dtMeshTile& tile = *static_cast<const dtNavMesh&>(*mesh).getTile(0);
  islands.assign(static_cast<std::size_t>(tile.header->polyCount), kNone);
  std::vector<std::size_t> waiting;
  for (std::size_t first = 0; first < islands.size(); ++first) {
    if (islands[first] == kNone) waiting.push_back(first);
    while (!waiting.empty()) {
      const std::size_t polygon = waiting.back();
      waiting.pop_back();
      if (islands[polygon] != kNone) continue;
      islands[polygon] = first;
      for (unsigned link = tile.polys[polygon].firstLink; link != DT_NULL_LINK; link = tile.links[link].next)
        waiting.push_back(mesh->decodePolyIdPoly(tile.links[link].ref));
    }
  }
}

Result<void> NavigationMesh::Check(const NavigationGeometry& geometry, const NavigationConfig& config) {
  const Range ranges[] = {
      {"WalkableHeight", config.walkable_height_m, 0.01f, 100},
      {"WalkableRadius", config.walkable_radius_m, 0, 50},
      {"WalkableClimbHeight", config.climb_height_m, 0, 50},
      {"WalkableSlopeAngle", config.slope_deg, 0, 90},
      {"MinimumRegionArea", config.min_region_cells, 0, 10'000},
      {"MergeRegionArea", config.merge_region_cells, 0, 10'000},
      {"CellSize", config.cell_size_m, 0.05f, 10},
  };
  for (const Range& range : ranges) {
    if (range.value >= range.min && range.value <= range.max) continue;
    return MeshFault(std::string(range.name) + " is " + Text(range.value),
                     "it is a number from " + Text(range.min) + " to " + Text(range.max));
  }
  if (geometry.empty()) {
    return MeshFault("there is no fixed object to walk on",
                     "make boxes or meshes of mass 0 first (Core.SetMass(object, 0)); planes are not walked on");
  }
  if (geometry.triangles.size() / 3 > kMaxTriangles || CoveredCells(geometry, config) > kMaxCoveredCells) {
    return MeshFault("the fixed objects are too many or too large for one navigation mesh",
                     "use fewer or smaller ones, or a greater CellSize");
  }
  return {};
}

double NavigationMesh::CoveredCells(const NavigationGeometry& geometry, const NavigationConfig& config) {
  // The horizontal bounding box of each triangle, clipped to the space that a mesh can cover. The triangle is half of
  // it.
  double cells = 0;
  for (std::size_t i = 0; i + 2 < geometry.triangles.size(); i += 3) {
    float min[2] = {kHalfExtent_m, kHalfExtent_m}, max[2] = {-kHalfExtent_m, -kHalfExtent_m};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::size_t vertex = static_cast<std::size_t>(geometry.triangles[i + corner]) * 3;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const float v = std::clamp(geometry.vertices[vertex + 2 * axis], -kHalfExtent_m, kHalfExtent_m);
        min[axis] = std::min(min[axis], v);
        max[axis] = std::max(max[axis], v);
      }
    }
    cells += (double{max[0]} - min[0] + config.cell_size_m) * (double{max[1]} - min[1] + config.cell_size_m) / 2;
  }
  return cells / (double{config.cell_size_m} * config.cell_size_m);
}

Result<std::unique_ptr<NavigationMesh>> NavigationMesh::Build(const NavigationGeometry& geometry,
                                                              const NavigationConfig& config) {
  if (const Result<void> checked = Check(geometry, config); !checked.ok()) return checked.error();
  Result<BuiltNavigation> built = FindOrBuild(geometry, config);
  if (!built.ok()) return built.error();

  auto impl = std::make_unique<Impl>();
  const Diagnostic no_memory = MeshFault("there is no memory for the navigation mesh", "use a greater CellSize");
  if (!impl->mesh || !impl->query ||
      dtStatusFailed(impl->mesh->init(built->tile, built->tile_size, DT_TILE_FREE_DATA))) {
    dtFree(built->tile);
    return no_memory;
  }
  const int polygons = static_cast<int>(built->triangles.size());
  const int nodes = std::clamp(2 * polygons, 2048, 65'000);
  if (dtStatusFailed(impl->query->init(impl->mesh.get(), nodes))) return no_memory;
  impl->FindIslands();
  impl->keeps_points = config.keeps_points;
  impl->triangles = std::move(built->triangles);
  impl->corridor.resize(static_cast<std::size_t>(std::clamp(polygons, 1, kMaxPathPoints)));
  impl->crossed.resize(kMaxPathPoints);
  impl->points.resize(std::size_t{3} * kMaxPathPoints);
  impl->min = impl->max = impl->triangles[0][0];
  float sum = 0;
  for (const auto& triangle : impl->triangles) {
    for (const Vec3 v : triangle) {
      impl->min = {std::min(impl->min.x, v.x), std::min(impl->min.y, v.y), std::min(impl->min.z, v.z)};
      impl->max = {std::max(impl->max.x, v.x), std::max(impl->max.y, v.y), std::max(impl->max.z, v.z)};
    }
    sum += std::abs(Cross(triangle[1] - triangle[0], triangle[2] - triangle[0]).y) / 2;
    impl->area_sums_m2.push_back(sum);
  }
  return std::unique_ptr<NavigationMesh>(new NavigationMesh(std::move(impl)));
}

NavigationMesh::NavigationMesh(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
NavigationMesh::~NavigationMesh() = default;

std::vector<Vec3> NavigationMesh::FindPath(Vec3 from, Vec3 to) const {
  float start[3], end[3];
  const dtPolyRef first = impl_->Nearest(from, kSnapPath_m, start);
  const dtPolyRef last = impl_->Nearest(to, kSnapPath_m, end);
  if (first == 0 || last == 0) return {};
  int count = 0;
  const dtStatus found = impl_->query->findPath(first, last, start, end, &impl_->filter, impl_->corridor.data(), &count,
                                                static_cast<int>(impl_->corridor.size()));
  const bool whole =
      dtStatusSucceed(found) && count > 0 && impl_->corridor[static_cast<std::size_t>(count) - 1] == last;
  if (!whole) return {};
  int points = 0;
  impl_->query->findStraightPath(start, end, impl_->corridor.data(), count, impl_->points.data(), nullptr,
                                 impl_->crossed.data(), &points, kMaxPathPoints, DT_STRAIGHTPATH_ALL_CROSSINGS);
  std::vector<Vec3> path;
  for (int i = 0; i < points; ++i) {
    const Vec3 point = FromFloats(&impl_->points[static_cast<std::size_t>(i) * 3]);
    if (path.empty() || path.back() != point) path.push_back(point);
  }
  return path;
}

bool NavigationMesh::MayReach(Vec3 from, Vec3 to, float within_m) const {
  constexpr int kMostNear = 512;
  constexpr float kAnyHeight_m = 1000;
  float start[3];
  const dtPolyRef first = impl_->Nearest(from, kSnapPath_m, start);
  const bool covers = to.x > impl_->min.x && to.x < impl_->max.x && to.z > impl_->min.z && to.z < impl_->max.z;
  if (first == 0 || !covers || !(within_m >= 0)) return true;
  const float center[3] = {to.x, to.y, to.z}, half[3] = {within_m, kAnyHeight_m, within_m};
  std::array<dtPolyRef, kMostNear> near;
  int count = 0;
  const dtStatus asked =
      impl_->query->queryPolygons(center, half, &impl_->filter, near.data(), &count, static_cast<int>(near.size()));
  if (dtStatusFailed(asked) || count == kMostNear) return true;
  return std::any_of(near.begin(), near.begin() + count, [&](dtPolyRef polygon) {
    if (impl_->IslandOf(polygon) != impl_->IslandOf(first)) return false;
    float nearest[3];
    if (dtStatusFailed(impl_->query->closestPointOnPoly(polygon, center, nearest, nullptr))) return true;
    const float x = nearest[0] - to.x, z = nearest[2] - to.z;
    return x * x + z * z <= within_m * within_m;
  });
}

Vec3 NavigationMesh::FindClosestPoint(Vec3 point) const {
  if (impl_->keeps_points) return point;
  float nearest[3];
  return impl_->Nearest(point, kSnapPoint_m, nearest) == 0 ? point : FromFloats(nearest);
}

Vec3 NavigationMesh::RandomPoint(RandomStream& random) const {
  const float wanted = random.Unit() * impl_->area_sums_m2.back();
  const auto found = std::upper_bound(impl_->area_sums_m2.begin(), impl_->area_sums_m2.end(), wanted);
  const auto index =
      std::min(static_cast<std::size_t>(found - impl_->area_sums_m2.begin()), impl_->triangles.size() - 1);
  // Reflecting the far half of the parallelogram gives a uniform distribution over the triangle.
  float u = random.Unit(), v = random.Unit();
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const auto& [a, b, c] = impl_->triangles[index];
  return a + (b - a) * u + (c - a) * v;
}

const std::vector<std::array<Vec3, 3>>& NavigationMesh::triangles() const {
  return impl_->triangles;
}
Vec3 NavigationMesh::min() const {
  return impl_->min;
}
Vec3 NavigationMesh::max() const {
  return impl_->max;
}
float NavigationMesh::area_m2() const {
  return impl_->area_sums_m2.back();
}

}  // namespace soarbox::world
