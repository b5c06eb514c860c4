// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/scene_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viewer/drawable_mesh.h"
#include "viewer/interpolate.h"

namespace soarbox::viewer {
namespace {

using world::DrawableSnapshot;
using world::ShapeKind;

/// Minimum heights in the picture, in px, for the fine, the middle and the coarse mesh; smaller things have the tiny
/// mesh. First for bodies (rifles use the height of a soldier), then for agents of other shapes.
using Heights = std::array<float, 3>;
constexpr Heights kBodyHeights_px{100, 40, 34}, kAgentHeights_px{95, 38, 20};
constexpr float kSoldier_m = 1.75f;
/// Maximum numbers of bodies and rifles with the fine and the middle mesh.
constexpr std::size_t kMostFine = 24, kMostMiddle = 64, kMostFineSlow = 6, kMostMiddleSlow = 16;

/// The level for a height in the picture. `levels` is their number and `before` the last level. Hysteresis prevents
/// flickering at the border.
std::size_t LevelFor(const Heights& heights_px, float px, std::size_t before, std::size_t levels) {
  std::size_t level = 0;
  for (const float least : heights_px) {
    if (level + 1 >= levels || px >= (before <= level ? least / 1.1f : least)) break;
    ++level;
  }
  return level;
}

}  // namespace

SceneView::SceneView(Ogre::SceneManager& scene, Materials& materials, float reach, OnWarning on_warning)
    : scene_(scene), materials_(materials), reach_(reach), on_warning_(std::move(on_warning)) {}

SceneView::~SceneView() {
  // Ogre's scene must not refer to our objects when the engine ends it.
  for (const auto& [key, batch] : batches_) batch->detachFromParent();
  for (const auto& [key, batch] : body_batches_) batch->detachFromParent();
  for (const auto& [key, batch] : model_batches_) batch->detachFromParent();
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
  shown_.clear();
  bodies_shown_.clear();
  models_shown_.clear();
  agents_.clear();
  for (const world::LightSnapshot& light : newest.lights) {
    if (light.kind != world::LightKind::kDirectional) continue;
    sunlight_ = light.direction;
    break;
  }
  for (const world::AgentSnapshot& agent : newest.agents) agents_[agent.id] = &agent;
  // Ids ascend in both lists.
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
      bodies_shown_.push_back(&thing);
    } else if (auto model = drawable.bones.empty() ? nullptr : MovingModelOf(drawable)) {
      ShowModel(thing, std::move(model), drawable, before, blend);
      models_shown_.push_back(&thing);
    } else {
      Dress(thing, drawable, agent, LooksLikeABody(drawable, agent));
      Place(thing, drawable, before, blend);
      shown_.push_back(&thing);
    }
    thing.agent = agent != nullptr ? agent->id : 0;
  }
  for (auto it = things_.begin(); it != things_.end();) {
    if (it->second.seen == update_count_) {
      ++it;
      continue;
    }
    Undress(it->second);
    it = things_.erase(it);
  }
}

void SceneView::Dress(Thing& thing, const DrawableSnapshot& drawable, const world::AgentSnapshot* agent,
                      bool agent_body) {
  const bool own_color = agent_body && !IsAgentColorMaterial(drawable.material.value());
  Clothes clothes{drawable.shape, drawable.size, drawable.texture_repeats, drawable.mesh, drawable.material, {},
                  agent_body};
  if (own_color) {
    clothes.kind = agent->kind;
    clothes.alive = agent->alive;
    clothes.failed = agent->failed;
  }
  if (thing.clothes == clothes) return;
  Undress(thing);
  const MeshLibrary::Found& mesh = meshes_.For(drawable, agent_body);
  if (mesh.is_stand_in) WarnOnce("mesh", drawable.mesh, "a box with magenta squares is shown instead");
  const bool from_mesh = WearsItsOwn(drawable, mesh.material);
  const std::string& name = own_color ? agent->kind : from_mesh ? mesh.material : drawable.material.value();
  const auto material = [&](Placing placing) -> const Materials::Found& {
    return own_color ? materials_.AgentBody(agent->kind, agent->alive, agent->failed, placing)
                     : materials_.Named(name, placing);
  };
  const Materials::Found& found = material(Placing::kMany);
  if (found.is_stand_in) WarnOnce("material", name, "magenta squares are shown instead");
  const Ogre::MeshPtr& finest = mesh.levels.front();
  thing.radius_m = finest->getBoundingSphereRadius();
  thing.height_m = finest->getBounds().getSize().y;
  if (found.is_opaque) {
    for (const Ogre::MeshPtr& level : mesh.levels)
      thing.levels.push_back(&BatchOf(level, found, drawable.shape == ShapeKind::kPlane));
  } else {
    thing.node = scene_.getRootSceneNode()->createChildSceneNode();
    thing.entity = scene_.createEntity(finest);
    thing.entity->setMaterial(material(Placing::kOne).material);
    thing.entity->setCastShadows(false);
    thing.entity->setRenderQueueGroup(kClearQueue);
    thing.node->attachObject(thing.entity);
  }
  thing.clothes = std::move(clothes);
}

InstanceBatch& SceneView::BatchOf(const Ogre::MeshPtr& mesh, const Materials::Found& material, bool is_ground) {
  std::unique_ptr<InstanceBatch>& batch = batches_[{mesh->getName(), material.material->getName()}];
  if (batch) return *batch;
  const Ogre::SubMesh& part = *mesh->getSubMesh(0);
  batch =
      std::make_unique<InstanceBatch>(scene_, SharedShape{part.vertexData, part.indexData}, InstanceBatch::kMostRows);
  batch->setMaterial(material.material);
  batch->setCastShadows(!is_ground);
  batch->setRenderQueueGroup(is_ground ? kGroundQueue : kSolidQueue);
  scene_.getRootSceneNode()->createChildSceneNode()->attachObject(batch.get());
  return *batch;
}

void SceneView::ShowBody(Thing& thing, const world::BodyMesh& mesh, const DrawableSnapshot& drawable,
                         const DrawableSnapshot* before, float blend, const world::AgentSnapshot* agent) {
  if (!thing.body || thing.model) {
    Undress(thing);
    thing.body = std::make_unique<PosedBody>();
  }
  thing.look = LookOf(mesh, drawable);
  const bool is_own = drawable.material.empty() || drawable.material.value().starts_with("SF_");
  if (is_own) {
    thing.material.clear();
    thing.trim = TeamColor(agent != nullptr ? agent->team : std::string());
  } else if (thing.material != drawable.material.value()) {
    thing.material = drawable.material.value();
    thing.trim = materials_.Named(thing.material, Placing::kBones).trim;
  }

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

void SceneView::ShowModel(Thing& thing, std::shared_ptr<const model::Model> model, const DrawableSnapshot& drawable,
                          const DrawableSnapshot* before, float blend) {
  if (thing.model != model) {
    Undress(thing);
    thing.body = std::make_unique<PosedBody>();
    thing.radius_m = std::max(world::Length(model->min), world::Length(model->max));
    thing.model = std::move(model);
  }
  PosedBody& body = *thing.body;
  body.place = {{drawable.position, drawable.orientation}, drawable.scale};
  body.bones = drawable.bones.value();
  if (before != nullptr) {
    body.place.at = {BetweenPositions(before->position, drawable.position, blend),
                     BetweenOrientations(before->orientation, drawable.orientation, blend)};
    const std::vector<world::BonePose>& last = before->bones.value();
    for (std::size_t i = 0; i < body.bones.size() && last.size() == body.bones.size(); ++i) {
      world::BonePose& bone = body.bones[i];
      bone = {world::Between(last[i].position, bone.position, blend),
              BetweenOrientations(last[i].orientation, bone.orientation, blend),
              world::Between(last[i].scale, bone.scale, blend)};
    }
  }
  thing.visible = drawable.visible && IsFinite(body.place.at.position) && IsFinite(drawable.scale);
  if (drawable.shows_skeleton && body.bones.size() == thing.model->rig.skeleton.bones().size())
    AddSkeletonLines(thing.model->rig.skeleton, {drawable.position, drawable.orientation, drawable.scale},
                     drawable.bones);
}

void SceneView::HoldFeet(Thing& thing, const DrawableSnapshot& drawable, const DrawableSnapshot* before) {
  if (!thing.feet) thing.feet = std::make_unique<Feet>();
  Feet& feet = *thing.feet;
  if (!feet.now.empty() && feet.tick == tick_) return;
  // If a few ticks were not shown, the last one is still valid.
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

InstanceBatch& SceneView::BodiesOf(const Thing& thing, BodyDetail detail) {
  std::unique_ptr<InstanceBatch>& batch = body_batches_[{thing.look, detail, thing.material}];
  if (batch) return *batch;
  batch = std::make_unique<InstanceBatch>(scene_, bodies_.For(thing.look, detail), 1);
  const Materials::Found& found =
      thing.material.empty() ? materials_.Soldier() : materials_.Named(thing.material, Placing::kBones);
  if (found.is_stand_in) WarnOnce("material", thing.material, "magenta squares are shown instead");
  batch->setMaterial(found.material);
  batch->setCastShadows(found.is_opaque);
  batch->setRenderQueueGroup(found.is_opaque ? kSolidQueue : kClearQueue);
  scene_.getRootSceneNode()->createChildSceneNode()->attachObject(batch.get());
  return *batch;
}

InstanceBatch& SceneView::ModelsOf(const std::shared_ptr<const model::Model>& model) {
  std::unique_ptr<InstanceBatch>& batch = model_batches_[model];
  if (batch) return *batch;
  batch = std::make_unique<InstanceBatch>(scene_, bodies_.For(model), 1);
  batch->setMaterial(materials_.Named(kModelMaterial, Placing::kBones).material);
  batch->setCastShadows(true);
  batch->setRenderQueueGroup(kSolidQueue);
  scene_.getRootSceneNode()->createChildSceneNode()->attachObject(batch.get());
  return *batch;
}

void SceneView::BeginFrame(const Ogre::Camera& camera, int height_px, std::uint32_t inside) {
  for (auto& [key, batch] : batches_) batch->Begin();
  for (auto& [key, batch] : body_batches_) batch->Begin();
  for (auto& [key, batch] : model_batches_) batch->Begin();
  bones_.Begin();
  const float down = std::max(0.15f, -world::Normalized(sunlight_).y);
  const Sight sight{camera, camera.getDerivedPosition(),
                    static_cast<float>(height_px) / (2 * std::tan(camera.getFOVy().valueRadians() / 2)), 1 / down,
                    inside};
  for (Thing* thing : shown_) AddThing(*thing, sight);
  AddBodies(sight);
  AddModels(sight);
}

void SceneView::EndFrame() {
  for (auto& [key, batch] : batches_) batch->End();
  for (auto& [key, batch] : body_batches_) batch->End();
  for (auto& [key, batch] : model_batches_) batch->End();
  bones_.End();
}

void SceneView::AddThing(Thing& thing, const Sight& sight) const {
  const bool is_shown = thing.visible && (sight.inside == 0 || thing.agent != sight.inside);
  if (thing.node != nullptr) {
    thing.node->setVisible(is_shown);
    return;
  }
  if (!is_shown || thing.levels.empty()) return;
  if (thing.levels.size() > 1) {
    const float away = std::max((ToOgre(thing.position) - sight.eye).length(), 0.1f);
    thing.detail = LevelFor(kAgentHeights_px, thing.height_m * std::abs(thing.scale.y) * sight.px_per_m / away,
                            thing.detail, thing.levels.size());
  } else {
    thing.detail = 0;
  }
  Ogre::Matrix3 turn;
  ToOgre(thing.orientation).ToRotationMatrix(turn);
  const world::Vec3 p = thing.position, s = thing.scale;
  const Ogre::Vector4 rows[3] = {{turn[0][0] * s.x, turn[0][1] * s.y, turn[0][2] * s.z, p.x},
                                 {turn[1][0] * s.x, turn[1][1] * s.y, turn[1][2] * s.z, p.y},
                                 {turn[2][0] * s.x, turn[2][1] * s.y, turn[2][2] * s.z, p.z}};
  const float radius_m = thing.radius_m * std::max({std::abs(s.x), std::abs(s.y), std::abs(s.z)});
  // A shadow can be coarser than the thing itself.
  const std::size_t shadow = std::min(thing.detail + 1, thing.levels.size() - 1);
  using Shown = InstanceBatch::Shown;
  thing.levels[thing.detail]->Add(p, radius_m, shadow == thing.detail ? Shown::kEverywhere : Shown::kInPicture, rows);
  if (shadow != thing.detail) thing.levels[shadow]->Add(p, radius_m, Shown::kInShadow, rows);
}

bool SceneView::MattersTo(const Sight& sight, const Thing& thing) const {
  const world::Vec3 at = thing.body->place.at.position;
  // From its place along the light to the point where the light has descended by the body's height, and some more.
  constexpr float kDown_m = 4;
  const float along = std::min(kDown_m * sight.light_per_m, 25.0f);
  const world::Vec3 middle = at + world::Normalized(sunlight_) * (along / 2);
  return sight.camera.isVisible(Ogre::Sphere(ToOgre(middle), kBodyReach_m + along / 2));
}

void SceneView::AddBodies(const Sight& sight) {
  // The nearest first, because only some get the finer meshes.
  std::vector<std::pair<float, Thing*>> order;
  for (Thing* thing : bodies_shown_) {
    if (!thing->visible || (sight.inside != 0 && thing->agent == sight.inside) || !MattersTo(sight, *thing)) continue;
    if (thing->body->bones.size() != static_cast<std::size_t>(BodyLibrary::SkeletonOf(thing->look).count())) continue;
    order.emplace_back((ToOgre(thing->body->place.at.position) - sight.eye).length(), thing);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const bool is_slow = reach_ < 1;
  const std::size_t most_fine = is_slow ? kMostFineSlow : kMostFine,
                    most_middle = is_slow ? kMostMiddleSlow : kMostMiddle;
  constexpr std::size_t kLevels = 4;
  std::size_t fine = 0, middle = 0;
  for (const auto& [away, thing] : order) {
    std::size_t level =
        LevelFor(kBodyHeights_px, kSoldier_m * sight.px_per_m * reach_ / std::max(away, 0.1f), thing->detail, kLevels);
    if (level == 0 && ++fine > most_fine) level = 1;
    if (level == 1 && ++middle > most_middle) level = 2;
    thing->detail = level;
    const auto detail = static_cast<BodyDetail>(level);
    // As for things; on slow renderers distant bodies cast no shadow.
    const auto shadow = static_cast<BodyDetail>(std::min(level + 1, kLevels - 1));
    const bool casts = !is_slow || level < 2;
    const float first_row = bones_.Add(*thing->body, thing->look);
    using Shown = InstanceBatch::Shown;
    const bool is_same = casts && shadow == detail;
    AddBody(BodiesOf(*thing, detail), *thing->body, thing->trim, first_row,
            is_same ? Shown::kEverywhere : Shown::kInPicture);
    if (casts && !is_same) AddBody(BodiesOf(*thing, shadow), *thing->body, thing->trim, first_row, Shown::kInShadow);
  }
}

void SceneView::AddModels(const Sight& sight) {
  // Animations may move corners away from where they are at rest.
  constexpr float kReach = 2;
  for (const Thing* thing : models_shown_) {
    if (!thing->visible || (sight.inside != 0 && thing->agent == sight.inside)) continue;
    const SkinPlace& place = thing->body->place;
    const float largest = std::max({std::abs(place.scale.x), std::abs(place.scale.y), std::abs(place.scale.z)});
    const Ogre::Vector4 row(1, 1, 1, bones_.Add(*thing->body, *thing->model));
    ModelsOf(thing->model)
        .Add(place.at.position, kReach * largest * thing->radius_m, InstanceBatch::Shown::kEverywhere, &row);
  }
}

std::optional<SceneView::Figure> SceneView::FigureOf(std::uint32_t agent) const {
  if (agent == 0) return std::nullopt;
  for (const Thing* thing : bodies_shown_) {
    if (thing->agent == agent && thing->look != world::BodyLook::kRifle) return Figure{thing->look, thing->body.get()};
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
  thing.visible = drawable.visible && IsFinite(position) && IsFinite(drawable.scale);
  if (!thing.visible) return;
  thing.position = position;
  thing.orientation = orientation;
  thing.scale = drawable.scale;
  if (thing.node == nullptr) return;
  thing.node->setPosition(ToOgre(position));
  thing.node->setOrientation(ToOgre(orientation));
  thing.node->setScale(ToOgre(drawable.scale));
}

void SceneView::Undress(Thing& thing) {
  if (thing.entity != nullptr) scene_.destroyEntity(thing.entity);
  if (thing.node != nullptr) scene_.destroySceneNode(thing.node);
  thing.entity = nullptr;
  thing.node = nullptr;
  thing.levels.clear();
  thing.clothes.reset();
  thing.body.reset();
  thing.model.reset();
}

}  // namespace soarbox::viewer
