// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string_view>

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// The building kit that the sandbox's scripts name: 34 blocks, walls, doors, windows, pillars and roofs in
/// "models/nobiax_modular/" (world::kModularMeshes), built from chamfered boxes with the bounds that the world uses.

/// Returns the mesh of a resource such as "models/nobiax_modular/modular_block.mesh"; nothing if there is no such
/// piece.
std::optional<MeshData> ModularMesh(std::string_view resource_name);

}  // namespace soarbox::viewer
