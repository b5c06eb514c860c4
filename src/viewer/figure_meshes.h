// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string_view>

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// Returns the mesh of a box or a capsule whose material is a thing or a creature, not a surface: "Soarbox/Rock",
/// "Soarbox/Medkit", "Soarbox/Sheep". Nothing for other materials. The mesh fills the shape: `size` is the extents of
/// the box, or the diameter, height and diameter of the capsule. It has the same centre and faces +z.
std::optional<MeshData> FigureMesh(std::string_view material, world::Vec3 size);

/// Whether this material has such a mesh.
bool IsFigure(std::string_view material);

}  // namespace soarbox::viewer
