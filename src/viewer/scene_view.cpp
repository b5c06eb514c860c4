// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/scene_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/interpolate.h"

namespace soarbox::viewer {
namespace {

using world::DrawableSnapshot;
using world::ShapeKind;

/// How near bodies are drawn in full, and in middle detail.
constexpr float kFineUntil_m = 14, kMiddleUntil_m = 38;
/// How many bodies and rifles at most.
constexpr std::size_t kMostFine = 24, kMostMiddle = 64, kMostFineSlow = 6, kMostMiddleSlow = 16;
const std::string kTeamPrefix = "team/";  // Of names of materials: own cloth, with the colour of a team.

/// A capsule of an agent, of the size of a body rather than of something that it carries.
bool LooksLikeABody(const DrawableSnapshot& drawable, const world::AgentSnapshot* agent) {
  return agent != nullptr && drawable.shape == ShapeKind::kCapsule && drawable.size.y > 0.6f * agent->height_m;
}

}  // namespace

SceneView::SceneView(Ogre::SceneManager& scene, Materials& materials, float reach, OnWarning on_warning)
    : scene_(scene), materials_(materials), reach_(reach), on_warning_(std::move(on_warning)) {}

SceneView::~SceneView() {
  // Ogre's scene must not hold what we own when the engine takes it down.
  for (const auto& [key, batch] : batches_) batch->detachFromParent();
}

void SceneView::WarnOnce(const std::string& kind, const std::string& name, const std::string& instead) {
  if (!warned_.insert(kind + "/" + name).second || !on_warning_) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.message = "there is no " + kind + " '" + name + "': " + instead;
  on_warning_(warning);
}

void SceneView::Update(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend) {
  ++update_count_;
  if (newest.tick != tick_) {
    const auto ticks = newest.tick > tick_ ? newest.tick - tick_ : 0;
    tick_s_ = ticks > 0 ? (newest.time_s - time_s_) / static_cast<double>(ticks) : 0;
    tick_ = newest.tick;
    time_s_ = newest.time_s;
  }
  skeleton_lines_.clear();
  bodies_shown_.clear();
  agents_.clear();
  for (const world::AgentSnapshot& agent : newest.agents) agents_[agent.id] = &agent;
  // Ids ascend in both.
  static const world::SharedList<DrawableSnapshot> kNothing;
  const world::SharedList<DrawableSnapshot>& earlier =
      previous != nullptr && blend < 1 ? previous->drawables : kNothing;
  auto next_before = earlier.begin();
  for (const DrawableSnapshot& drawable : newest.drawables) {
    const auto owner = drawable.belongs_to_agent ? agents_.find(drawable.owner_id) : agents_.end();
    const world::AgentSnapshot* agent = owner != agents_.end() ? owner->second : nullptr;
    Thing& thing = things_[drawable.id];
    thing.seen = update_count_;
    while (next_before != earlier.end() && next_before->id < drawable.id) ++next_before;
    const bool was_there = next_before != earlier.end() && next_before->id == drawable.id;
    const DrawableSnapshot* before = was_there ? &*next_before : nullptr;
    const world::BodyMesh* body = drawable.shape == ShapeKind::kMesh && !drawable.bones.empty()
                                      ? world::FindBodyMesh(drawable.mesh.value())
                                      : nullptr;
    if (body != nullptr) {
      ShowBody(thing, *body, drawable, before, blend, agent);
      bodies_shown_.push_back(drawable.id);
    } else {
      Dress(thing, drawable, agent, LooksLikeABody(drawable, agent));
      Place(thing, drawable, before, blend);
    }
    thing.agent = agent != nullptr ? agent->id : 0;
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
  thing.body.reset();
  if (thing.entity == nullptr || thing.mesh_name != mesh.mesh->getName())
    Wear(thing, mesh.mesh, drawable.shape != ShapeKind::kPlane);

  const bool own_color = agent_body && !IsAgentColorMaterial(drawable.material.value());
  // "NobiaxModular" is what the pieces of the kit wear anyway.
  const bool from_mesh =
      drawable.material.empty() || (drawable.shape == ShapeKind::kMesh && drawable.material == "NobiaxModular");
  const std::string& name = own_color ? agent->kind : from_mesh ? mesh.material : drawable.material.value();
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
  const bool is_ground = drawable.shape == ShapeKind::kPlane;
  thing.entity->setRenderQueueGroup(!found.is_opaque ? kClearQueue : is_ground ? kGroundQueue : kSolidQueue);
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
                         const DrawableSnapshot* before, float blend, const world::AgentSnapshot* agent) {
  if (!thing.body) {
    Destroy(thing);
    thing.body = std::make_unique<PosedBody>();
    thing.body->id = drawable.id;
  }
  // A soldier may change its uniform by the name of its material.
  thing.look = mesh.look;
  if (mesh.look != world::BodyLook::kRifle && drawable.material == "SF_Soldier_Body")
    thing.look = world::BodyLook::kSoldier;
  if (mesh.look != world::BodyLook::kRifle && drawable.material == "SF_Soldier_Body_Dark")
    thing.look = world::BodyLook::kDarkSoldier;
  const bool is_own = drawable.material.empty() || drawable.material.value().starts_with("SF_");
  thing.material_name =
      is_own ? kTeamPrefix + (agent != nullptr ? agent->team : std::string()) : drawable.material.value();

  PosedBody& body = *thing.body;
  body.place = {{drawable.position, drawable.orientation}, drawable.scale};
  const bool walks = agent != nullptr && thing.look != world::BodyLook::kRifle;
  if (walks) HoldFeet(thing, drawable, before);
  const std::vector<world::BonePose>& bones = walks ? thing.feet->now : drawable.bones.value();
  body.bones = bones;
  if (before != nullptr) {
    body.place.at = {BetweenPositions(before->position, drawable.position, blend),
                     BetweenOrientations(before->orientation, drawable.orientation, blend)};
    const std::vector<world::BonePose>& last = walks ? thing.feet->before : before->bones.value();
    if (last.size() == bones.size()) {
      for (std::size_t i = 0; i < bones.size(); ++i) {
        body.bones[i] = {world::Between(last[i].position, bones[i].position, blend),
                         BetweenOrientations(last[i].orientation, bones[i].orientation, blend)};
      }
    }
  }
  thing.visible = drawable.visible && IsFinite(body.place.at.position) && IsFinite(drawable.scale);
  if (drawable.shows_skeleton)
    AddSkeletonLines(mesh.rig().skeleton, {drawable.position, drawable.orientation}, drawable.bones);
}

void SceneView::HoldFeet(Thing& thing, const DrawableSnapshot& drawable, const DrawableSnapshot* before) {
  if (!thing.feet) thing.feet = std::make_unique<Feet>();
  Feet& feet = *thing.feet;
  if (!feet.now.empty() && feet.tick == tick_) return;
  // Of a few ticks that nobody saw, the last one is known.
  constexpr std::uint64_t kFew = 5;
  const bool goes_on = !feet.now.empty() && tick_ > feet.tick && tick_ - feet.tick <= kFew && tick_s_ > 0;
  auto missed = static_cast<float>(goes_on ? tick_ - feet.tick : 1);
  if (!goes_on) feet.plant.Forget();
  const auto follow = [&](const DrawableSnapshot& at, float ticks) {
    feet.before = std::exchange(feet.now, at.bones);
    const SkinPlace place{{at.position, at.orientation}, at.scale};
    feet.plant.Follow(place, ticks * static_cast<float>(tick_s_ > 0 ? tick_s_ : 1 / 30.0), feet.now);
  };
  if (before != nullptr && (!goes_on || missed > 1)) {
    follow(*before, std::max(1.0f, missed - 1));
    missed = 1;
  }
  follow(drawable, missed);
  feet.tick = tick_;
}

BodyBatch& SceneView::BatchFor(const Thing& thing) {
  std::unique_ptr<BodyBatch>& batch = batches_[{thing.look, thing.detail, thing.material_name}];
  if (batch) return *batch;
  batch = std::make_unique<BodyBatch>(bodies_.For(thing.look, thing.detail));
  const bool is_own = thing.material_name.starts_with(kTeamPrefix);
  const Materials::Found& found = is_own ? materials_.Soldier(thing.material_name.substr(kTeamPrefix.size()))
                                         : materials_.Named(thing.material_name);
  if (found.is_stand_in) WarnOnce("material", thing.material_name, "magenta squares stand in for it");
  batch->setMaterial(found.material);
  // On slow renderers what is far has no shadow.
  batch->setCastShadows(found.is_opaque && (reach_ >= 1 || thing.detail != BodyDetail::kCoarse));
  batch->setRenderQueueGroup(found.is_opaque ? kSolidQueue : kClearQueue);
  scene_.getRootSceneNode()->createChildSceneNode()->attachObject(batch.get());
  batch->Begin();
  return *batch;
}

void SceneView::PoseBodies(const world::CameraSnapshot& camera, std::uint32_t inside) {
  for (auto& [key, batch] : batches_) batch->Begin();
  // The nearest first: of many, only some are worth the finer meshes.
  std::vector<std::pair<float, Thing*>> order;
  const float zoom = std::tan(camera.vertical_fov_deg * 0.00872665f) / std::tan(22.5f * 0.01745329f);
  for (const std::uint32_t id : bodies_shown_) {
    Thing& thing = things_[id];
    if (!thing.visible || (inside != 0 && thing.agent == inside)) continue;
    order.emplace_back(world::Distance(camera.position, thing.body->place.at.position) * zoom / reach_, &thing);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const bool is_slow = reach_ < 1;
  const std::size_t most_fine = is_slow ? kMostFineSlow : kMostFine,
                    most_middle = is_slow ? kMostMiddleSlow : kMostMiddle;
  std::size_t fine = 0, middle = 0;
  for (const auto& [away, thing] : order) {
    // A little further back than forth, so that nothing flickers at the border.
    const auto limit = [thing = thing](float metres, BodyDetail finer) {
      return thing->detail <= finer ? metres * 1.1f : metres;
    };
    if (away < limit(kFineUntil_m, BodyDetail::kFine) && fine < most_fine) {
      thing->detail = BodyDetail::kFine;
      ++fine;
    } else if (away < limit(kMiddleUntil_m, BodyDetail::kMiddle) && middle < most_middle) {
      thing->detail = BodyDetail::kMiddle;
      ++middle;
    } else {
      thing->detail = BodyDetail::kCoarse;
    }
  }
  // In the order of the snapshot, so that each keeps its place in its batch.
  for (const std::uint32_t id : bodies_shown_) {
    const Thing& thing = things_[id];
    if (!thing.visible || (inside != 0 && thing.agent == inside)) continue;
    BatchFor(thing).Add(*thing.body, thing.detail != BodyDetail::kCoarse);
  }
  for (auto& [key, batch] : batches_) batch->End();
  for (auto& [id, thing] : things_) {
    if (!thing.body && thing.agent != 0 && thing.agent == inside) thing.node->setVisible(false);
  }
}

std::optional<SceneView::Figure> SceneView::FigureOf(std::uint32_t agent) const {
  if (agent == 0) return std::nullopt;
  for (const std::uint32_t id : bodies_shown_) {
    const Thing& thing = things_.at(id);
    if (thing.agent == agent && thing.look != world::BodyLook::kRifle) return Figure{thing.look, thing.body.get()};
  }
  return std::nullopt;
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
