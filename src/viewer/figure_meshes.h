// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string_view>

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// What a box or a capsule of this material looks like when the material is of a thing or a creature rather than of a
/// surface: "Soarbox/Rock", "Soarbox/Medkit", "Soarbox/Sheep". Empty for other materials. The mesh fills the shape:
/// `size` is a box's extents, or a capsule's diameter, height, diameter; its middle is the shape's, and it faces +z.
std::optional<MeshData> FigureMesh(std::string_view material, world::Vec3 size);

/// Whether there is such a figure.
bool IsFigure(std::string_view material);

}  // namespace soarbox::viewer
