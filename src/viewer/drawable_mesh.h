// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/mesh_data.h"
#include "world/body_meshes.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// Whether the drawable is a capsule that is the agent's body, not something that the agent carries.
bool LooksLikeABody(const world::DrawableSnapshot& drawable, const world::AgentSnapshot* agent);

/// The mesh of a drawable without a skeleton, chosen by its shape, size, mesh name and material.
struct DrawableMesh {
  MeshData data;
  bool is_stand_in = false;  ///< The mesh name is unknown, and this box is drawn instead.
};
/// The material of models from files: their vertices contain the colours.
inline constexpr const char* kModelMaterial = "Soarbox/Model";
/// Whether the drawable is drawn with its mesh's own material instead of the material that it names.
bool WearsItsOwn(const world::DrawableSnapshot& drawable, const std::string& own_material);
/// `agent_body` gives a capsule the look of an agent.
DrawableMesh MeshOf(const world::DrawableSnapshot& drawable, bool agent_body);

/// Returns the look of a drawable with a skeleton. The material name may select another uniform for a soldier.
world::BodyLook LookOf(const world::BodyMesh& mesh, const world::DrawableSnapshot& drawable);

/// Whether it is the usual plain, which hills, trees and a fence surround (backdrop_meshes.h).
bool IsPlain(const world::DrawableSnapshot& drawable);

}  // namespace soarbox::viewer
