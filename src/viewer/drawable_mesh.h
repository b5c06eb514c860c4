// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/mesh_data.h"
#include "world/body_meshes.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// Whether it is a capsule of an agent, of the size of a body rather than of something that it carries.
bool LooksLikeABody(const world::DrawableSnapshot& drawable, const world::AgentSnapshot* agent);

/// The mesh that a drawable without a skeleton asks for, by its shape, size, mesh and material.
struct DrawableMesh {
  MeshData data;
  bool is_stand_in = false;  ///< The resource name is unknown; this is a box that says so.
};
/// What models from files wear: their corners bring their colours along.
inline constexpr const char* kModelMaterial = "Soarbox/Model";
/// Whether a drawable wears its mesh's own material, and not the one that it names.
bool WearsItsOwn(const world::DrawableSnapshot& drawable, const std::string& own_material);
/// `agent_body` gives a capsule the look of an agent.
DrawableMesh MeshOf(const world::DrawableSnapshot& drawable, bool agent_body);

/// What a drawable with a skeleton looks like: a soldier may change its uniform by the name of its material.
world::BodyLook LookOf(const world::BodyMesh& mesh, const world::DrawableSnapshot& drawable);

/// Whether it is the usual plain, which hills, trees and a fence stand around (backdrop_meshes.h).
bool IsPlain(const world::DrawableSnapshot& drawable);

}  // namespace soarbox::viewer
