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

/// The output of Recast, ready for Detour.
struct BuiltNavigation {
  /// A tile of Detour, allocated with dtAlloc. The caller owns it.
  unsigned char* tile = nullptr;
  int tile_size = 0;
  std::vector<std::array<Vec3, 3>> triangles;
};

/// Identifies the source of a mesh. The same hash means the same mesh.
std::uint64_t SourceHash(const NavigationGeometry& geometry, const NavigationConfig& config);
Result<BuiltNavigation> BuildNavigation(const NavigationGeometry& geometry, const NavigationConfig& config);

}  // namespace soarbox::world
