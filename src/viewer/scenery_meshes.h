// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string_view>

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// A tree or a rock of world::kSceneryMeshes, grown from its seed; empty if there is none of that name.
std::optional<MeshData> SceneryMeshFor(std::string_view resource_name);

}  // namespace soarbox::viewer
