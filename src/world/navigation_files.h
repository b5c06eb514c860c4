// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "world/navigation_build.h"

namespace soarbox::world {

// For the navigation_*.cpp files only.

/// Meshes as files, for the next program that builds the same world. There are none until KeepNavigation is called
/// (shared_navigation.h). A file that is damaged, or was written by another program or with another Recast, is not
/// read. Safe from any thread; a reader never sees half a file.

/// The mesh that a file holds for this source; nothing if there is none. The tile is the caller's.
std::optional<BuiltNavigation> FindKeptNavigation(std::uint64_t source);
/// Writes the mesh of this source. Does nothing if that fails: it will be built again.
void KeepBuiltNavigation(std::uint64_t source, const BuiltNavigation& built);

}  // namespace soarbox::world
