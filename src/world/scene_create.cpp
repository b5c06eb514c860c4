// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "world/body_meshes.h"
#include "world/rotation.h"
#include "world/scene.h"
#include "world/scene_node.h"

namespace soarbox::world {
namespace {

constexpr float kThin_m = 0.01f;
constexpr float kTextureRepeat_m = 2.0f;
constexpr float kLightRange_m = 30.0f;

// Negative sizes and NaN count as zero.
float LengthOf(float metres) {
  return std::isfinite(metres) ? std::clamp(metres, 0.0f, 1e6f) : 0.0f;
}

MeshBounds Around(Vec3 half) {
  return {-half, half};
}

}  // namespace

NodeId Scene::CreateEmpty(NodeId parent, EntityId owner, bool owner_is_agent) {
  Node node;
  node.owner = owner;
  node.owner_is_agent = owner_is_agent;
  node.belongs_to_entity = true;
  return Add(parent, std::move(node));
}

NodeId Scene::CreateBox(NodeId parent, float width_m, float height_m, float length_m, float u_tile, float v_tile) {
  Node node;
  ShapeBox(node, width_m, height_m, length_m, u_tile, v_tile);
  return Add(parent, std::move(node));
}

NodeId Scene::CreateCapsule(NodeId parent, float height_m, float radius_m) {
  Node node;
  ShapeCapsule(node, height_m, radius_m);
  return Add(parent, std::move(node));
}

NodeId Scene::CreateMesh(NodeId parent, std::string_view mesh) {
  Node node;
  ShapeMesh(node, mesh);
  return Add(parent, std::move(node));
}

NodeId Scene::CreatePlane(NodeId parent, float length_m, float width_m) {
  Node node;
  ShapePlane(node, length_m, width_m);
  return Add(parent, std::move(node));
}

void Scene::ShapeBox(Node& node, float width_m, float height_m, float length_m, float u_tile, float v_tile) {
  node.content = NodeContent::kDrawable;
  node.drawable.shape = ShapeKind::kBox;
  node.drawable.size = {LengthOf(width_m), LengthOf(height_m), LengthOf(length_m)};
  node.drawable.material = "White";
  if (IsFinite(u_tile) && IsFinite(v_tile)) node.drawable.texture_repeats = {u_tile, v_tile, 1};
  node.bounds = Around(node.drawable.size / 2);
}

void Scene::ShapeCapsule(Node& node, float height_m, float radius_m) {
  const float radius = LengthOf(radius_m);
  const float height = std::max(LengthOf(height_m), 2 * radius);
  node.content = NodeContent::kDrawable;
  node.drawable.shape = ShapeKind::kCapsule;
  node.drawable.size = {radius, height, 0};
  node.drawable.material = "White";
  node.bounds = Around({radius, height / 2, radius});
}

void Scene::ShapeMesh(Node& node, std::string_view mesh) {
  node.bounds = catalog_.LookUpMesh(mesh);
  node.content = NodeContent::kDrawable;
  if (catalog_.HasMesh(mesh)) {
    node.drawable.shape = ShapeKind::kMesh;
    node.drawable.mesh = mesh;
    if (const Rig* rig = RigOfMesh(mesh)) node.animator = std::make_unique<Animator>(*rig);
    return;
  }
  node.drawable.shape = ShapeKind::kBox;
  node.drawable.size = node.bounds.max - node.bounds.min;
  node.drawable.material = "White";
}

void Scene::ShapePlane(Node& node, float length_m, float width_m) {
  const float length = LengthOf(length_m), width = LengthOf(width_m);
  node.content = NodeContent::kDrawable;
  node.drawable.shape = ShapeKind::kPlane;
  node.drawable.size = {width, 0, length};
  node.drawable.texture_repeats = {width / kTextureRepeat_m, length / kTextureRepeat_m, 1};
  node.drawable.material = "White";
  node.bounds = Around({width / 2, 0, length / 2});
}

NodeId Scene::CreateCircle(NodeId parent, float radius_m) {
  Node node;
  node.content = NodeContent::kRing;
  node.drawable.size = {LengthOf(radius_m), 0, 0};
  node.drawable.material = "White";
  node.bounds = Around({LengthOf(radius_m) + kThin_m, kThin_m, LengthOf(radius_m) + kThin_m});
  return Add(parent, std::move(node));
}

NodeId Scene::CreateCylinder(NodeId parent, float height_m, float radius_m) {
  const float radius = LengthOf(radius_m), height = LengthOf(height_m);
  Node node;
  node.content = NodeContent::kDrawable;
  node.drawable.shape = ShapeKind::kCylinder;
  node.drawable.size = {radius, height, 0};
  node.drawable.material = "White";
  node.offset = {0, height / 2, 0};
  node.bounds = Around({radius, height / 2, radius});
  return Add(parent, std::move(node));
}

NodeId Scene::CreateLine(NodeId parent, Vec3 from, Vec3 to) {
  if (!IsFinite(from) || !IsFinite(to)) return NodeId::kNone;
  Node node;
  node.content = NodeContent::kDrawable;
  node.drawable.shape = ShapeKind::kCylinder;
  node.drawable.material = "White";
  node.is_line = true;
  const NodeId id = Add(parent, std::move(node));
  SetLineStartEnd(id, from, to);
  return id;
}

bool Scene::SetLineStartEnd(NodeId line, Vec3 from, Vec3 to) {
  Node* node = Find(line);
  if (!node || !node->is_line || !IsFinite(from) || !IsFinite(to)) return false;
  const float length = Distance(from, to);
  node->drawable.size = {kThin_m, length, 0};
  node->offset = (from + to) / 2;
  node->offset_turn = ShortestArc({0, 1, 0}, to - from);
  node->bounds = Around({kThin_m, length / 2, kThin_m});
  Changed(*node);
  return true;
}

NodeId Scene::CreateParticle(NodeId parent, std::string_view template_name) {
  if (!Contains(parent)) return NodeId::kNone;
  Node node;
  node.content = NodeContent::kParticle;
  node.particle.effect = catalog_.LookUpParticle(template_name);
  return Add(parent, std::move(node));
}

NodeId Scene::CreateDirectionalLight(NodeId parent, Vec3 direction) {
  if (!IsFinite(direction)) return NodeId::kNone;
  Node node;
  node.content = NodeContent::kLight;
  node.light.kind = LightKind::kDirectional;
  if (LengthSquared(direction) > 0) node.light.direction = Normalized(direction);
  return Add(parent, std::move(node));
}

NodeId Scene::CreatePointLight(NodeId parent, Vec3 position) {
  if (!IsFinite(position)) return NodeId::kNone;
  Node node;
  node.content = NodeContent::kLight;
  node.light.kind = LightKind::kPoint;
  node.position = position;
  const NodeId id = Add(parent, std::move(node));
  SetLightRange(id, kLightRange_m);
  return id;
}

}  // namespace soarbox::world
