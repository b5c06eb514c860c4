// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "model/model.h"
#include "viewer/mesh_data.h"
#include "viewer/skin_mesh.h"
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

/// The mesh of a model from a file: at rest, or in the space of its skin, in which its joints move it.
MeshData ModelMesh(const model::Model& model, bool in_skin_space);

/// The model of a drawable that joints move; null if the drawable shows no such model.
std::shared_ptr<const model::Model> MovingModelOf(const world::DrawableSnapshot& drawable);

/// For each joint of a model, three rows of four numbers: the matrix that transforms a vertex from the space of the
/// skin to world space.
std::vector<float> JointRows(const model::Model& model, const std::vector<world::BonePose>& bones,
                             const SkinPlace& place);

/// Weights of a corner as bytes that add up to 255.
std::array<std::uint8_t, 4> WeightBytes(const std::array<float, 4>& weights);

/// Returns the look of a drawable with a skeleton. The material name may select another uniform for a soldier.
world::BodyLook LookOf(const world::BodyMesh& mesh, const world::DrawableSnapshot& drawable);

/// Whether it is the usual plain, which hills, trees and a fence surround (backdrop_meshes.h).
bool IsPlain(const world::DrawableSnapshot& drawable);

}  // namespace soarbox::viewer
