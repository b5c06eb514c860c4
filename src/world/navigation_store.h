// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "world/navigation_build.h"

namespace soarbox::world {

// For the navigation_*.cpp files only.

/// A cache of the meshes that this process and its forks have built. Nothing is shared until ShareNavigation is called
/// (shared_navigation.h). A mesh that does not fit into the cache is not shared: each process builds it.
///
/// The same source gives the same mesh, so the cache does not change results. Thread-safe and safe across these
/// processes. A process that is killed while it writes leaves no incomplete mesh.

/// Checksum of a mesh's bytes: its tile, then its triangles.
std::uint64_t CheckOfNavigation(std::string_view bytes);
/// A mesh with a copy of these bytes; nothing if memory is exhausted. The caller owns the tile.
std::optional<BuiltNavigation> CopyNavigation(std::string_view bytes, std::size_t tile_bytes);

/// The mesh for this source; nothing if no process has built it yet. The caller owns the tile.
std::optional<BuiltNavigation> FindSharedNavigation(std::uint64_t source);
/// Adds the mesh of this source to the cache.
void OfferNavigation(std::uint64_t source, const BuiltNavigation& built);

}  // namespace soarbox::world
