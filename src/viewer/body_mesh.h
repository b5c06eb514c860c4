// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/skin_mesh.h"
#include "world/body_meshes.h"

namespace soarbox::viewer {

/// Level of detail of a body.
enum class BodyDetail : std::uint8_t { kFine, kMiddle, kCoarse, kTiny };

/// The mesh of a body with a skeleton, in its bind pose: a soldier in full gear, or the rifle.
SkinMesh MakeBodyMesh(world::BodyLook look, BodyDetail detail);

SkinMesh MakeSoldierMesh(BodyDetail detail, bool dark);
SkinMesh MakeRifleMesh(BodyDetail detail);
SkinMesh MakeTinySoldierMesh(bool dark);
SkinMesh MakeTinyRifleMesh();

}  // namespace soarbox::viewer
