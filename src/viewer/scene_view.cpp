// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/scene_view.h"

#include "viewer/interpolate.h"

namespace soarbox::viewer {
namespace {

using world::DrawableSnapshot;
using world::ShapeKind;

/// How near bodies are drawn in full, and in middle detail.
constexpr float kFineUntil_m = 14, kMiddleUntil_m = 38;

/// A capsule of an agent, of the size of a body rather than of something that it carries.
bool LooksLikeABody(const DrawableSnapshot& drawable, const world::AgentSnapshot* agent) {
  return agent != nullptr && drawable.shape == ShapeKind::kCapsule && drawable.size.y > 0.6f * agent->height_m;
}

}  // namespace

SceneView::SceneView(Ogre::SceneManager& scene, Materials& materials, float reach, OnWarning on_warning)
    : scene_(scene), materials_(materials), reach_(reach), on_warning_(std::move(on_warning)) {}

void SceneView::WarnOnce(const std::string& kind, const std::string& name, const std::string& instead) {
  if (!warned_.insert(kind + "/" + name).second || !on_warning_) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.message = "there is no " + kind + " '" + name + "': " + instead;
  on_warning_(warning);
}

void SceneView::Update(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend,
                       world::Vec3 eye, std::uint32_t inside) {
  ++update_count_;
  skeleton_lines_.clear();
  agents_.clear();
  before_.clear();
  for (const world::AgentSnapshot& agent : newest.agents) agents_[agent.id] = &agent;
  if (previous != nullptr && blend < 1) {
    for (const DrawableSnapshot& drawable : previous->drawables) before_[drawable.id] = &drawable;
  }
  for (const DrawableSnapshot& drawable : newest.drawables) {
    const auto owner = drawable.belongs_to_agent ? agents_.find(drawable.owner_id) : agents_.end();
    const world::AgentSnapshot* agent = owner != agents_.end() ? owner->second : nullptr;
    Thing& thing = things_[drawable.id];
    thing.seen = update_count_;
    const auto found = before_.find(drawable.id);
    const DrawableSnapshot* before = found != before_.end() ? found->second : nullptr;
    const world::BodyMesh* body =
        drawable.shape == ShapeKind::kMesh && !drawable.bones.empty() ? world::FindBodyMesh(drawable.mesh) : nullptr;
    if (body != nullptr) {
      ShowBody(thing, *body, drawable, before, blend, agent, eye);
    } else {
      Dress(thing, drawable, agent, LooksLikeABody(drawable, agent));
      Place(thing, drawable, before, blend);
    }
    if (inside != 0 && agent != nullptr && agent->id == inside) thing.node->setVisible(false);
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
  if (thing.entity == nullptr || thing.mesh_name != mesh.mesh->getName())
    Wear(thing, mesh.mesh, drawable.shape != ShapeKind::kPlane);

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
  thing.entity->setRenderQueueGroup(found.is_opaque ? kSolidQueue : kClearQueue);
}

void SceneView::Wear(Thing& thing, const Ogre::MeshPtr& mesh, bool casts_shadows) {
  Destroy(thing);
  thing.node = scene_.getRootSceneNode()->createChildSceneNode();
  thing.entity = scene_.createEntity(mesh);
  thing.entity->setCastShadows(casts_shadows);
  thing.node->attachObject(thing.entity);
  thing.mesh_name = mesh->getName();
  thing.material_name.clear();
}

void SceneView::ShowBody(Thing& thing, const world::BodyMesh& mesh, const DrawableSnapshot& drawable,
                         const DrawableSnapshot* before, float blend, const world::AgentSnapshot* agent,
                         world::Vec3 eye) {
  // Coarser from further away; a little further back than forth, so that nothing flickers at the border.
  const float away = world::Distance(eye, drawable.position) / reach_;
  const auto limit = [&](float metres, BodyDetail finer) {
    return thing.body && thing.detail <= finer ? metres * 1.1f : metres;
  };
  const BodyDetail detail = away < limit(kFineUntil_m, BodyDetail::kFine)       ? BodyDetail::kFine
                            : away < limit(kMiddleUntil_m, BodyDetail::kMiddle) ? BodyDetail::kMiddle
                                                                                : BodyDetail::kCoarse;
  // A soldier may change its uniform by the name of its material.
  world::BodyLook look = mesh.look;
  if (look != world::BodyLook::kRifle && drawable.material == "SF_Soldier_Body") look = world::BodyLook::kSoldier;
  if (look != world::BodyLook::kRifle && drawable.material == "SF_Soldier_Body_Dark")
    look = world::BodyLook::kDarkSoldier;
  if (!thing.body || thing.detail != detail || thing.look != look) {
    Destroy(thing);
    const char* suffix[] = {"/fine", "/middle", "/coarse"};
    auto body = std::make_unique<SkinnedBody>(bodies_.For(look, detail), "Soarbox/body/" + std::to_string(drawable.id) +
                                                                             suffix[static_cast<std::size_t>(detail)]);
    Wear(thing, body->mesh(), true);
    thing.body = std::move(body);
    thing.detail = detail;
    thing.look = look;
  }

  const bool is_own = drawable.material.empty() || drawable.material.starts_with("SF_");
  const std::string team = agent != nullptr ? agent->team : "";
  const std::string wanted = is_own ? "body/" + team : drawable.material;
  if (wanted != thing.material_name) {
    thing.material_name = wanted;
    const Materials::Found& found = is_own ? materials_.Soldier(team) : materials_.Named(drawable.material);
    if (found.is_stand_in) WarnOnce("material", drawable.material, "magenta squares stand in for it");
    thing.entity->setMaterial(found.material);
    thing.entity->setCastShadows(found.is_opaque);
    thing.entity->setRenderQueueGroup(found.is_opaque ? kSolidQueue : kClearQueue);
  }

  Place(thing, drawable, before, blend);
  if (before != nullptr && before->bones.size() == drawable.bones.size()) {
    std::vector<world::BonePose> bones(drawable.bones.size());
    for (std::size_t i = 0; i < bones.size(); ++i) {
      bones[i] = {world::Between(before->bones[i].position, drawable.bones[i].position, blend),
                  BetweenOrientations(before->bones[i].orientation, drawable.bones[i].orientation, blend)};
    }
    thing.body->Move(bones);
  } else {
    thing.body->Move(drawable.bones);
  }
  if (drawable.shows_skeleton)
    AddSkeletonLines(mesh.rig().skeleton, {drawable.position, drawable.orientation}, drawable.bones);
}

void SceneView::AddSkeletonLines(const world::Skeleton& skeleton, const world::BonePose& model,
                                 const std::vector<world::BonePose>& bones) {
  constexpr float kAxis_m = 0.035f;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const world::BonePose bone = model * bones[i];
    const int parent = skeleton.bones()[i].parent;
    if (parent >= 0)
      skeleton_lines_.push_back(
          {(model * bones[static_cast<std::size_t>(parent)]).position, bone.position, {1, 1, 1, 1}});
    skeleton_lines_.push_back({bone.position, bone.Apply({kAxis_m, 0, 0}), {1, 0.2f, 0.2f, 1}});
    skeleton_lines_.push_back({bone.position, bone.Apply({0, kAxis_m, 0}), {0.2f, 1, 0.2f, 1}});
    skeleton_lines_.push_back({bone.position, bone.Apply({0, 0, kAxis_m}), {0.3f, 0.5f, 1, 1}});
  }
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
  thing.body.reset();
}

}  // namespace soarbox::viewer
