// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string_view>

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// The building kit that the sandbox's scripts name: 34 blocks, walls, doors, windows, pillars and roofs under
/// "models/nobiax_modular/" (world::kModularMeshes), rebuilt from chamfered boxes within the world's bounds.

/// The mesh of a resource such as "models/nobiax_modular/modular_block.mesh"; empty if we have no such piece.
std::optional<MeshData> ModularMesh(std::string_view resource_name);

}  // namespace soarbox::viewer
