// SPDX-License-Identifier: BSD-2-Clause
#include "world/modular_meshes.h"
#include "world/scene_node.h"
#include "world/world.h"
#include "world/world_impl.h"

// Creation of objects: each has a node with a drawable, and a body.
namespace soarbox::world {

Object& World::Impl::AddObject(EntityId id, NodeId node, ObjectKind kind, BodyDef def) {
  def.owner = id;
  const BodyId body = physics.Add(def);
  auto& slot = objects[id];
  slot.reset(new Object(physics, scene, id, node, kind, body));
  if (by_body.size() <= static_cast<std::size_t>(body)) by_body.resize(static_cast<std::size_t>(body) + 1);
  by_body[static_cast<std::size_t>(body)] = slot.get();
  object_ids.push_back(id);
  return *slot;
}

EntityId World::CreateBox(float width_m, float height_m, float length_m, float u_tile, float v_tile) {
  const EntityId id = impl_->NextEntity();
  const NodeId node = impl_->scene.CreateEmpty(NodeId::kRoot, id, false);
  Scene::Node& looks = *impl_->scene.Find(node);
  impl_->scene.ShapeBox(looks, width_m, height_m, length_m, u_tile, v_tile);
  BodyDef def;
  def.shape = BodyShape::kBox;
  def.size = looks.drawable.size;
  impl_->AddObject(id, node, ObjectKind::kBox, def);
  return id;
}

EntityId World::CreateCapsule(float height_m, float radius_m) {
  const EntityId id = impl_->NextEntity();
  const NodeId node = impl_->scene.CreateEmpty(NodeId::kRoot, id, false);
  Scene::Node& looks = *impl_->scene.Find(node);
  impl_->scene.ShapeCapsule(looks, height_m, radius_m);
  BodyDef def;
  def.shape = BodyShape::kCapsule;
  def.size = looks.drawable.size;
  impl_->AddObject(id, node, ObjectKind::kCapsule, def);
  return id;
}

EntityId World::CreateObject(std::string_view mesh) {
  const EntityId id = impl_->NextEntity();
  const NodeId node = impl_->scene.CreateEmpty(NodeId::kRoot, id, false);
  Scene::Node& looks = *impl_->scene.Find(node);
  impl_->scene.ShapeMesh(looks, mesh);
  if (looks.animator) impl_->scene.animated_.push_back(node);
  BodyDef def;
  def.shape = BodyShape::kMesh;
  def.bounds = looks.bounds;
  def.doorway = HasDoorway(looks.drawable.mesh.value());
  impl_->AddObject(id, node, ObjectKind::kMesh, def);
  return id;
}

EntityId World::CreatePlane(float length_m, float width_m) {
  const EntityId id = impl_->NextEntity();
  const NodeId node = impl_->scene.CreateEmpty(NodeId::kRoot, id, false);
  impl_->scene.ShapePlane(*impl_->scene.Find(node), length_m, width_m);
  BodyDef def;
  def.shape = BodyShape::kPlane;
  impl_->AddObject(id, node, ObjectKind::kPlane, def);
  return id;
}

EntityId World::CreatePhysicsCapsule(float height_m, float radius_m) {
  const EntityId id = impl_->NextEntity();
  const NodeId node = impl_->scene.CreateEmpty(NodeId::kRoot, id, false);
  BodyDef def;
  def.shape = BodyShape::kCapsule;
  def.size = {radius_m, height_m, 0};
  impl_->AddObject(id, node, ObjectKind::kPhysicsCapsule, def);
  return id;
}

EntityId World::CreatePhysicsSphere(float radius_m) {
  const EntityId id = impl_->NextEntity();
  const NodeId node = impl_->scene.CreateEmpty(NodeId::kRoot, id, false);
  BodyDef def;
  def.shape = BodyShape::kSphere;
  def.size = {radius_m, 0, 0};
  impl_->AddObject(id, node, ObjectKind::kPhysicsSphere, def);
  return id;
}

EntityId World::CreateSensor(float width_m, float height_m, float length_m) {
  const EntityId id = impl_->NextEntity();
  const NodeId node = impl_->scene.CreateEmpty(NodeId::kRoot, id, false);
  BodyDef def;
  def.shape = BodyShape::kBox;
  def.size = {width_m, height_m, length_m};
  def.sensor = true;
  impl_->AddObject(id, node, ObjectKind::kSensor, def);
  return id;
}

}  // namespace soarbox::world
