// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/mesh_data.h"

namespace soarbox::viewer {

/// The side of the plain that these stand around.
inline constexpr float kPlainSide_m = 200;

/// Hills with trees around a plain, and a fence along its edge: they end the view and tell how far away things are.
/// Nobody can reach them, so they have no bodies.
MeshData HillsMesh();
MeshData TreesMesh();
MeshData FenceMesh();

}  // namespace soarbox::viewer
