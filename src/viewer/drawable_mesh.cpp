// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/drawable_mesh.h"

#include <algorithm>
#include <cmath>

#include "viewer/backdrop_meshes.h"
#include "viewer/figure_meshes.h"
#include "viewer/modular_mesh_shapes.h"
#include "viewer/scenery_mesh_shapes.h"
#include "viewer/shape_meshes.h"
#include "world/asset_store.h"

namespace soarbox::viewer {
namespace {

using world::DrawableSnapshot;
using world::ShapeKind;

/// The extents of a box or a capsule; nothing for other shapes.
world::Vec3 ExtentsOf(const DrawableSnapshot& d) {
  if (d.shape == ShapeKind::kBox) return d.size;
  return d.shape == ShapeKind::kCapsule ? world::Vec3{2 * d.size.x, d.size.y, 2 * d.size.x} : world::Vec3{};
}

}  // namespace

MeshData ModelMesh(const model::Model& model, bool in_skin_space) {
  MeshData mesh;
  mesh.material = kModelMaterial;
  mesh.vertices.reserve(model.corners.size());
  // Colours are stored in u, v and light, as the material requires.
  for (std::size_t i = 0; i < model.corners.size(); ++i) {
    const model::Corner& corner = model.corners[i];
    MeshVertex& vertex = mesh.vertices.emplace_back();
    vertex.position = in_skin_space ? model.skins[i].position : corner.position;
    vertex.normal = in_skin_space ? model.skins[i].normal : corner.normal;
    vertex.u = corner.red;
    vertex.v = corner.green;
    vertex.light = corner.blue;
  }
  mesh.indices = model.indices;
  return mesh;
}

std::shared_ptr<const model::Model> MovingModelOf(const DrawableSnapshot& drawable) {
  if (drawable.shape != ShapeKind::kMesh || world::AssetName(drawable.mesh.value()).empty()) return nullptr;
  auto model = model::FindModel(drawable.mesh.value());
  return model != nullptr && model->moves() ? model : nullptr;
}

std::vector<float> JointRows(const model::Model& model, const std::vector<world::BonePose>& bones,
                             const SkinPlace& place) {
  const model::Frame body = model::FrameOf({place.at.position, place.at.orientation, place.scale});
  std::vector<float> rows;
  rows.reserve(12 * model.joints.size());
  for (const model::Frame& joint : model::FramesOfJoints(model, bones)) {
    const model::Frame f = body * joint;
    rows.insert(rows.end(),
                {f.x.x, f.y.x, f.z.x, f.place.x, f.x.y, f.y.y, f.z.y, f.place.y, f.x.z, f.y.z, f.z.z, f.place.z});
  }
  return rows;
}

std::array<std::uint8_t, 4> WeightBytes(const std::array<float, 4>& weights) {
  constexpr int kWhole = 255;
  std::array<std::uint8_t, 4> bytes{};
  int left = kWhole;
  for (std::size_t i = 1; i < weights.size(); ++i) {
    const int part = std::clamp(static_cast<int>(std::lround(weights[i] * kWhole)), 0, left);
    bytes[i] = static_cast<std::uint8_t>(part);
    left -= part;
  }
  bytes[0] = static_cast<std::uint8_t>(left);
  return bytes;
}

bool WearsItsOwn(const DrawableSnapshot& drawable, const std::string& own_material) {
  const std::string& wanted = drawable.material.value();
  // "NobiaxModular" is the default material of the kit's pieces.
  return wanted.empty() || own_material == kModelMaterial ||
         (drawable.shape == ShapeKind::kMesh && wanted == "NobiaxModular");
}

bool LooksLikeABody(const DrawableSnapshot& drawable, const world::AgentSnapshot* agent) {
  return agent != nullptr && drawable.shape == ShapeKind::kCapsule && drawable.size.y > 0.6f * agent->height_m;
}

DrawableMesh MeshOf(const DrawableSnapshot& d, bool agent_body) {
  if (auto figure = FigureMesh(d.material.value(), ExtentsOf(d))) return {*std::move(figure)};
  switch (d.shape) {
    case ShapeKind::kBox:
      return {
          BoxMesh(d.size * -0.5f, d.size * 0.5f, {.repeats_u = d.texture_repeats.x, .repeats_v = d.texture_repeats.y})};
    case ShapeKind::kCapsule:
      return {agent_body ? AgentMesh(d.size.x, d.size.y) : CapsuleMesh(d.size.x, d.size.y)};
    case ShapeKind::kCylinder:
      return {CylinderMesh(d.size.x, d.size.y)};
    case ShapeKind::kPlane:
      return {PlaneMesh(d.size.x, d.size.z, d.texture_repeats.x, d.texture_repeats.y)};
    case ShapeKind::kSphere:
      return {SphereMesh(d.size.x)};
    case ShapeKind::kMesh:
      break;
  }
  if (const auto model = model::FindModel(d.mesh.value())) return {ModelMesh(*model, false)};
  if (auto modular = ModularMesh(d.mesh.value())) return {*std::move(modular)};
  if (auto scenery = SceneryMeshFor(d.mesh.value())) return {*std::move(scenery)};
  DrawableMesh box{BoxMesh({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}), true};
  box.data.material = "Soarbox/Missing";
  return box;
}

world::BodyLook LookOf(const world::BodyMesh& mesh, const DrawableSnapshot& drawable) {
  if (mesh.look == world::BodyLook::kRifle) return mesh.look;
  if (drawable.material == "SF_Soldier_Body") return world::BodyLook::kSoldier;
  return drawable.material == "SF_Soldier_Body_Dark" ? world::BodyLook::kDarkSoldier : mesh.look;
}

bool IsPlain(const DrawableSnapshot& drawable) {
  return drawable.visible && drawable.shape == ShapeKind::kPlane && drawable.size.x == kPlainSide_m &&
         drawable.size.z == kPlainSide_m && world::Length(drawable.position) < 0.5f;
}

}  // namespace soarbox::viewer
