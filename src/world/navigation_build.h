// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "diagnostics/result.h"
#include "world/math.h"
#include "world/navigation_config.h"
#include "world/navigation_geometry.h"

// For the navigation_*.cpp files only.
namespace soarbox::world {

/// What Recast makes of the geometry, ready for Detour.
struct BuiltNavigation {
  /// A tile of Detour's; memory of dtAlloc. Whoever has it owns it.
  unsigned char* tile = nullptr;
  int tile_size = 0;
  std::vector<std::array<Vec3, 3>> triangles;
};

/// Names what a mesh is made from: the same hash, the same mesh.
std::uint64_t SourceHash(const NavigationGeometry& geometry, const NavigationConfig& config);
Result<BuiltNavigation> BuildNavigation(const NavigationGeometry& geometry, const NavigationConfig& config);

}  // namespace soarbox::world
