// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "world/navigation_build.h"

namespace soarbox::world {

// For the navigation_*.cpp files only.

/// Meshes that this process and those forked from it have built. Nothing is shared until ShareNavigation is called
/// (shared_navigation.h); each process builds again what does not fit.
///
/// The same source gives the same mesh, so nobody can tell whether it was built or found. Safe from any thread and any
/// of these processes; one that is killed while it writes leaves nothing behind.

/// The checksum of a mesh's bytes: its tile, then its triangles.
std::uint64_t CheckOfNavigation(std::string_view bytes);
/// A mesh from these bytes, which it copies; nothing if there is no memory. The tile is the caller's.
std::optional<BuiltNavigation> CopyNavigation(std::string_view bytes, std::size_t tile_bytes);

/// What was made from this source; nothing if nobody has built it yet. The tile is the caller's.
std::optional<BuiltNavigation> FindSharedNavigation(std::uint64_t source);
/// Offers what was made from this source to the others.
void OfferNavigation(std::uint64_t source, const BuiltNavigation& built);

}  // namespace soarbox::world
