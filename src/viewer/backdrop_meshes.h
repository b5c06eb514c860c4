// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// Side length of the plain that these meshes surround.
inline constexpr float kPlainSide_m = 200;

/// Hills with trees around a plain, and a fence along its edge. They limit the view and show distances. They have no
/// bodies in the world, because no agent can reach them.
MeshData HillsMesh();
MeshData TreesMesh();
MeshData FenceMesh();

}  // namespace soarbox::viewer
