// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string_view>

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// Returns the mesh of a tree or a rock of world::kSceneryMeshes, computed from its seed; nothing for other names.
std::optional<MeshData> SceneryMeshFor(std::string_view resource_name);

}  // namespace soarbox::viewer
