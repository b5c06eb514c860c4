// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/scene_view.h"

#include "viewer/interpolate.h"

namespace soarbox::viewer {
namespace {

using world::DrawableSnapshot;
using world::ShapeKind;

/// A capsule of an agent, of the size of a body rather than of something that it carries.
bool LooksLikeABody(const DrawableSnapshot& drawable, const world::AgentSnapshot* agent) {
  return agent != nullptr && drawable.shape == ShapeKind::kCapsule && drawable.size.y > 0.6f * agent->height_m;
}

}  // namespace

SceneView::SceneView(Ogre::SceneManager& scene, Materials& materials, OnWarning on_warning)
    : scene_(scene), materials_(materials), on_warning_(std::move(on_warning)) {}

void SceneView::WarnOnce(const std::string& kind, const std::string& name, const std::string& instead) {
  if (!warned_.insert(kind + "/" + name).second || !on_warning_) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.message = "there is no " + kind + " '" + name + "': " + instead;
  on_warning_(warning);
}

void SceneView::Update(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend) {
  ++update_count_;
  agents_.clear();
  before_.clear();
  for (const world::AgentSnapshot& agent : newest.agents) agents_[agent.id] = &agent;
  if (previous != nullptr && blend < 1) {
    for (const DrawableSnapshot& drawable : previous->drawables) before_[drawable.id] = &drawable;
  }
  for (const DrawableSnapshot& drawable : newest.drawables) {
    const auto owner = drawable.belongs_to_agent ? agents_.find(drawable.owner_id) : agents_.end();
    const world::AgentSnapshot* agent = owner != agents_.end() ? owner->second : nullptr;
    const bool agent_body = LooksLikeABody(drawable, agent);
    Thing& thing = things_[drawable.id];
    thing.seen = update_count_;
    Dress(thing, drawable, agent, agent_body);
    const auto before = before_.find(drawable.id);
    Place(thing, drawable, before != before_.end() ? before->second : nullptr, blend);
  }
  for (auto it = things_.begin(); it != things_.end();) {
    if (it->second.seen == update_count_) {
      ++it;
      continue;
    }
    Destroy(it->second);
    it = things_.erase(it);
  }
}

void SceneView::Dress(Thing& thing, const DrawableSnapshot& drawable, const world::AgentSnapshot* agent,
                      bool agent_body) {
  const MeshLibrary::Found& mesh = meshes_.For(drawable, agent_body);
  if (mesh.is_stand_in) WarnOnce("mesh", drawable.mesh, "a box with magenta squares stands in for it");
  if (thing.entity == nullptr || thing.mesh_name != mesh.mesh->getName()) {
    Destroy(thing);
    thing.node = scene_.getRootSceneNode()->createChildSceneNode();
    thing.entity = scene_.createEntity(mesh.mesh);
    thing.entity->setCastShadows(drawable.shape != ShapeKind::kPlane);
    thing.node->attachObject(thing.entity);
    thing.mesh_name = mesh.mesh->getName();
    thing.material_name.clear();
  }

  const bool own_color = agent_body && !IsAgentColorMaterial(drawable.material);
  // "NobiaxModular" is what the pieces of the kit wear anyway.
  const bool from_mesh =
      drawable.material.empty() || (drawable.shape == ShapeKind::kMesh && drawable.material == "NobiaxModular");
  const std::string& name = own_color ? agent->kind : from_mesh ? mesh.material : drawable.material;
  std::string wanted = name;
  if (own_color) wanted += agent->alive ? (agent->failed ? "/2" : "/1") : "/0";
  if (wanted == thing.material_name) return;
  thing.material_name = wanted;
  const Materials::Found& found =
      own_color ? materials_.AgentBody(agent->kind, agent->alive, agent->failed) : materials_.Named(name);
  if (found.is_stand_in) WarnOnce("material", name, "magenta squares stand in for it");
  thing.entity->setMaterial(found.material);
  for (std::size_t i = 0; i < thing.entity->getNumManualLodLevels(); ++i) {
    thing.entity->getManualLodLevel(i)->setMaterial(found.material);
  }
  thing.entity->setCastShadows(found.is_opaque && drawable.shape != ShapeKind::kPlane);
}

void SceneView::Place(Thing& thing, const DrawableSnapshot& drawable, const DrawableSnapshot* before, float blend) {
  world::Vec3 position = drawable.position;
  world::Quat orientation = drawable.orientation;
  if (before != nullptr) {
    position = BetweenPositions(before->position, position, blend);
    orientation = BetweenOrientations(before->orientation, orientation, blend);
  }
  if (!IsFinite(position) || !IsFinite(drawable.scale)) {
    thing.node->setVisible(false);
    return;
  }
  thing.node->setPosition(ToOgre(position));
  thing.node->setOrientation(ToOgre(orientation));
  thing.node->setScale(ToOgre(drawable.scale));
  thing.node->setVisible(drawable.visible);
}

void SceneView::Destroy(Thing& thing) {
  if (thing.entity != nullptr) scene_.destroyEntity(thing.entity);
  if (thing.node != nullptr) scene_.destroySceneNode(thing.node);
  thing.entity = nullptr;
  thing.node = nullptr;
}

}  // namespace soarbox::viewer
