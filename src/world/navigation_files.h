// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "world/navigation_build.h"

namespace soarbox::world {

// For the navigation_*.cpp files only.

/// A cache of navigation meshes in files, for later programs that build the same world. It is off until KeepNavigation
/// is called (shared_navigation.h). Files that are damaged, or were written by another program or with another version
/// of Recast, are ignored. Thread-safe; a reader never sees an incomplete file.

/// The cached mesh for this source; nothing if there is none. The caller owns the tile.
std::optional<BuiltNavigation> FindKeptNavigation(std::uint64_t source);
/// Writes the mesh of this source. Ignores errors, because the mesh can be built again.
void KeepBuiltNavigation(std::uint64_t source, const BuiltNavigation& built);

}  // namespace soarbox::world
