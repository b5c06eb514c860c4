// SPDX-License-Identifier: BSD-2-Clause
#include "world/navigation_build.h"

#include <DetourNavMeshBuilder.h>
#include <Recast.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "diagnostics/problem.h"
#include "world/navigation_mesh.h"
#include "world/state_hash.h"

// Recast's stages in order: rasterize, filter, compact, erode, regions, contours, polygons, detail, tile.
namespace soarbox::world {
namespace {

constexpr float kMaxEdge_m = 20;
constexpr float kSimplification_cells = 1;
constexpr int kPolygonCorners = 3;
constexpr float kDetailDistance_cells = 5;
constexpr float kDetailError_cells = 1;
constexpr unsigned short kWalkFlag = 1;

template <auto Free>
struct Freed {
  template <typename T>
  void operator()(T* value) const {
    Free(value);
  }
};
using Heightfield = std::unique_ptr<rcHeightfield, Freed<rcFreeHeightField>>;
using CompactHeightfield = std::unique_ptr<rcCompactHeightfield, Freed<rcFreeCompactHeightfield>>;
using ContourSet = std::unique_ptr<rcContourSet, Freed<rcFreeContourSet>>;
using PolyMesh = std::unique_ptr<rcPolyMesh, Freed<rcFreePolyMesh>>;
using DetailMesh = std::unique_ptr<rcPolyMeshDetail, Freed<rcFreePolyMeshDetail>>;

Diagnostic Fault(std::string message, std::string hint) {
  return NewProblem(std::move(message), std::move(hint));
}

Diagnostic TooLarge(const char* stage) {
  return Fault(std::string("the world is too large or too rugged for one navigation mesh (") + stage + " failed)",
               "make a mesh of fewer objects or with a greater CellSize");
}

/// Rounds up. 0.4 m must be 4 cells of 0.1 m, although the quotient of the two floats is slightly greater.
int CellsUp(float metres, float cell) {
  return static_cast<int>(std::ceil(metres / cell - 1e-3f));
}
int CellsDown(float metres, float cell) {
  return static_cast<int>(std::floor(metres / cell + 1e-3f));
}

/// The cells are on a fixed grid over the entire space that a mesh can cover; only the part around the geometry is
/// built. Additional cells around it keep the ledge filter away from the border.
rcConfig Grid(const NavigationGeometry& geometry, const NavigationConfig& config) {
  constexpr int kMargin = 2;
  const float cell = config.cell_size_m, origin = -NavigationMesh::kHalfExtent_m;
  const int count = static_cast<int>(std::floor(-2 * origin / cell + 0.5f));
  Vec3 min, max;
  geometry.Bounds(min, max);
  const auto first = [&](float v) {
    return std::clamp(static_cast<int>(std::floor(std::clamp((v - origin) / cell, -1e6f, 1e6f))) - kMargin, 0, count);
  };
  const auto last = [&](float v) {
    return std::clamp(static_cast<int>(std::ceil(std::clamp((v - origin) / cell, -1e6f, 1e6f))) + kMargin, 0, count);
  };
  rcConfig grid{};
  grid.cs = grid.ch = cell;
  grid.bmin[0] = origin + static_cast<float>(first(min.x)) * cell;
  grid.bmin[1] = origin;
  grid.bmin[2] = origin + static_cast<float>(first(min.z)) * cell;
  grid.width = last(max.x) - first(min.x);
  grid.height = last(max.z) - first(min.z);
  grid.bmax[0] = grid.bmin[0] + static_cast<float>(grid.width) * cell;
  grid.bmax[1] = -origin;
  grid.bmax[2] = grid.bmin[2] + static_cast<float>(grid.height) * cell;
  grid.walkableSlopeAngle = config.slope_deg;
  grid.walkableHeight = std::max(3, CellsUp(config.walkable_height_m, cell));
  grid.walkableRadius = CellsUp(config.walkable_radius_m, cell);
  grid.walkableClimb = CellsDown(config.climb_height_m, cell);
  grid.maxEdgeLen = static_cast<int>(kMaxEdge_m / cell);
  grid.maxSimplificationError = kSimplification_cells;
  const auto square = [](float side) { return static_cast<int>(side * side); };
  grid.minRegionArea = square(config.min_region_cells);
  grid.mergeRegionArea = square(config.merge_region_cells);
  grid.maxVertsPerPoly = kPolygonCorners;
  grid.detailSampleDist = kDetailDistance_cells * cell;
  grid.detailSampleMaxError = kDetailError_cells * cell;
  return grid;
}

Result<CompactHeightfield> FillCells(rcContext& context, const rcConfig& grid, const NavigationGeometry& geometry) {
  Heightfield solid(rcAllocHeightfield());
  if (!solid || !rcCreateHeightfield(&context, *solid, grid.width, grid.height, grid.bmin, grid.bmax, grid.cs, grid.ch))
    return TooLarge("making the cells");
  const int vertices = static_cast<int>(geometry.vertices.size() / 3);
  const int triangles = static_cast<int>(geometry.triangles.size() / 3);
  std::vector<unsigned char> areas(static_cast<std::size_t>(triangles), RC_NULL_AREA);
  rcMarkWalkableTriangles(&context, grid.walkableSlopeAngle, geometry.vertices.data(), vertices,
                          geometry.triangles.data(), triangles, areas.data());
  if (!rcRasterizeTriangles(&context, geometry.vertices.data(), vertices, geometry.triangles.data(), areas.data(),
                            triangles, *solid, grid.walkableClimb))
    return TooLarge("filling the cells");
  rcFilterLowHangingWalkableObstacles(&context, grid.walkableClimb, *solid);
  rcFilterLedgeSpans(&context, grid.walkableHeight, grid.walkableClimb, *solid);
  rcFilterWalkableLowHeightSpans(&context, grid.walkableHeight, *solid);
  CompactHeightfield open(rcAllocCompactHeightfield());
  if (!open || !rcBuildCompactHeightfield(&context, grid.walkableHeight, grid.walkableClimb, *solid, *open))
    return TooLarge("finding the open space");
  return open;
}

Result<void> FindRegions(rcContext& context, const rcConfig& grid, rcCompactHeightfield& open) {
  if (!rcErodeWalkableArea(&context, std::min(grid.walkableRadius, 255), open))
    return TooLarge("keeping off the walls");
  if (!rcBuildDistanceField(&context, open)) return TooLarge("measuring distances");
  if (!rcBuildRegions(&context, open, 0, grid.minRegionArea, grid.mergeRegionArea)) return TooLarge("finding regions");
  return {};
}

Vec3 Corner(const rcPolyMesh& mesh, unsigned short index) {
  const unsigned short* v = &mesh.verts[std::size_t{index} * 3];
  return {mesh.bmin[0] + static_cast<float>(v[0]) * mesh.cs, mesh.bmin[1] + static_cast<float>(v[1]) * mesh.ch,
          mesh.bmin[2] + static_cast<float>(v[2]) * mesh.cs};
}

std::vector<std::array<Vec3, 3>> TrianglesOf(const rcPolyMesh& mesh) {
  std::vector<std::array<Vec3, 3>> triangles;
  triangles.reserve(static_cast<std::size_t>(mesh.npolys));
  for (int i = 0; i < mesh.npolys; ++i) {
    const unsigned short* corners = &mesh.polys[static_cast<std::size_t>(i) * kPolygonCorners * 2];
    triangles.push_back({Corner(mesh, corners[0]), Corner(mesh, corners[1]), Corner(mesh, corners[2])});
  }
  return triangles;
}

Result<BuiltNavigation> MakeTile(const rcConfig& grid, const NavigationConfig& config, rcPolyMesh& mesh,
                                 const rcPolyMeshDetail& detail) {
  for (int i = 0; i < mesh.npolys; ++i) mesh.flags[i] = kWalkFlag;
  dtNavMeshCreateParams params{};
  params.verts = mesh.verts;
  params.vertCount = mesh.nverts;
  params.polys = mesh.polys;
  params.polyAreas = mesh.areas;
  params.polyFlags = mesh.flags;
  params.polyCount = mesh.npolys;
  params.nvp = mesh.nvp;
  params.detailMeshes = detail.meshes;
  params.detailVerts = detail.verts;
  params.detailVertsCount = detail.nverts;
  params.detailTris = detail.tris;
  params.detailTriCount = detail.ntris;
  params.walkableHeight = config.walkable_height_m;
  params.walkableRadius = config.walkable_radius_m;
  params.walkableClimb = config.climb_height_m;
  std::copy_n(mesh.bmin, 3, params.bmin);
  std::copy_n(mesh.bmax, 3, params.bmax);
  params.cs = grid.cs;
  params.ch = grid.ch;
  params.buildBvTree = true;
  BuiltNavigation built;
  if (!dtCreateNavMeshData(&params, &built.tile, &built.tile_size)) return TooLarge("joining the polygons");
  built.triangles = TrianglesOf(mesh);
  return built;
}

}  // namespace

std::uint64_t SourceHash(const NavigationGeometry& geometry, const NavigationConfig& config) {
  StateHash hash;
  hash.Add(geometry.Hash());
  hash.Add(config.walkable_height_m);
  hash.Add(config.walkable_radius_m);
  hash.Add(config.climb_height_m);
  hash.Add(config.slope_deg);
  hash.Add(config.min_region_cells);
  hash.Add(config.merge_region_cells);
  hash.Add(config.cell_size_m);
  hash.Add(static_cast<std::uint64_t>(config.keeps_points));
  return hash.value();
}

Result<BuiltNavigation> BuildNavigation(const NavigationGeometry& geometry, const NavigationConfig& config) {
  rcContext context(false);
  const rcConfig grid = Grid(geometry, config);
  const Diagnostic nothing = Fault("nothing in this world is walkable for such an agent",
                                   "fixed boxes (mass 0) within 100 m of the origin are walked on, planes are not; the "
                                   "radius, height and MinimumRegionArea decide what is too narrow, low or small");
  if (grid.width <= 0 || grid.height <= 0) return nothing;
  Result<CompactHeightfield> open = FillCells(context, grid, geometry);
  if (!open.ok()) return open.error();
  if (const Result<void> regions = FindRegions(context, grid, **open); !regions.ok()) return regions.error();

  const ContourSet contours(rcAllocContourSet());
  if (!contours || !rcBuildContours(&context, **open, grid.maxSimplificationError, grid.maxEdgeLen, *contours))
    return TooLarge("finding outlines");
  if (contours->nconts == 0) return nothing;
  const PolyMesh mesh(rcAllocPolyMesh());
  if (!mesh || !rcBuildPolyMesh(&context, *contours, kPolygonCorners, *mesh)) return TooLarge("making polygons");
  if (mesh->npolys == 0) return nothing;
  const DetailMesh detail(rcAllocPolyMeshDetail());
  if (!detail ||
      !rcBuildPolyMeshDetail(&context, *mesh, **open, grid.detailSampleDist, grid.detailSampleMaxError, *detail))
    return TooLarge("adding detail");
  return MakeTile(grid, config, *mesh, *detail);
}

}  // namespace soarbox::world
