// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "viewer/body_library.h"
#include "viewer/foot_plant.h"
#include "viewer/materials.h"
#include "viewer/mesh_library.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// Keeps the state of each visible drawable of the snapshot by its id, and draws it. Equal things with one material are
/// one draw call (instance_batch.h). A transparent thing is an Ogre entity.
class SceneView {
 public:
  using OnWarning = std::function<void(const Diagnostic&)>;
  /// `reach`: factor of the distances up to which bodies are drawn in detail; below 1 on slow renderers.
  SceneView(Ogre::SceneManager& scene, Materials& materials, float reach, OnWarning on_warning);
  ~SceneView();
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  /// Applies the additions, changes, movements and removals of a snapshot. With `previous`, bodies are interpolated
  /// between the two by `blend`, 0..1.
  void Update(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend);

  /// Draws the things of the last Update for a camera whose picture is `height_px` high. Small and numerous things are
  /// drawn in less detail. Things of the agent `inside` are not drawn. Call it before each frame, and EndFrame after
  /// it.
  void BeginFrame(const Ogre::Camera& camera, int height_px, std::uint32_t inside);
  void EndFrame();
  /// The bones of the current frame.
  BoneTexture& bones() { return bones_; }

  /// The current body of an agent, without what it carries; nothing if it has no body with a skeleton.
  struct Figure {
    world::BodyLook look;
    const PosedBody* body;
  };
  std::optional<Figure> FigureOf(std::uint32_t agent) const;

  /// Lines of the skeletons that scripts show, in the poses of the last Update.
  const std::vector<world::LineSnapshot>& skeleton_lines() const { return skeleton_lines_; }

  /// Warns, once per name, that something is missing and what is shown instead.
  void WarnOnce(const std::string& kind, const std::string& name, const std::string& instead);

 private:
  /// The feet of an agent's soldier, and its bones at the last two ticks with held feet.
  struct Feet {
    FootPlant plant;
    std::uint64_t tick = 0;
    std::vector<world::BonePose> before, now;
  };
  /// The properties that determine a thing's look. `kind` and the fields after it: for things in the colour of an
  /// agent.
  struct Clothes {
    world::ShapeKind shape = world::ShapeKind::kMesh;
    world::Vec3 size, texture_repeats;
    world::Shared<std::string> mesh, material;
    std::string kind;
    bool is_body = false, alive = true, failed = false;
    bool operator==(const Clothes&) const = default;
  };
  struct Thing {
    std::optional<Clothes> clothes;      ///< None: not created yet.
    Ogre::SceneNode* node = nullptr;     ///< Of transparent things.
    Ogre::Entity* entity = nullptr;      ///< Of transparent things.
    std::vector<InstanceBatch*> levels;  ///< Of opaque things, finest first.
    float radius_m = 0;                  ///< Around its origin, unless it is scaled.
    float height_m = 0;
    world::Vec3 position, scale{1, 1, 1};
    world::Quat orientation;
    std::uint64_t seen = 0;
    std::unique_ptr<PosedBody> body;  ///< Of meshes with a skeleton; these have neither entity nor levels.
    std::unique_ptr<Feet> feet;
    std::size_t detail = 0;  ///< Index of the level in which it was drawn.
    world::BodyLook look = world::BodyLook::kSoldier;
    std::shared_ptr<const model::Model> model;  ///< Of models that move; `look` is then not used.
    std::string material;                       ///< Of bodies; empty: the material of soldiers.
    world::Color trim;                          ///< Of that material.
    bool visible = true;
    std::uint32_t agent = 0;  ///< The agent that it belongs to; 0: none.
  };
  /// Parameters of a frame.
  struct Sight {
    const Ogre::Camera& camera;
    Ogre::Vector3 eye;
    float px_per_m;        ///< Of a thing one metre away.
    float light_per_m;     ///< Distance along the sunlight up to which shadows matter, per metre above the ground.
    std::uint32_t inside;  ///< The agent whose things are not drawn; 0: none.
  };
  void Place(Thing& thing, const world::DrawableSnapshot& drawable, const world::DrawableSnapshot* before, float blend);
  void Dress(Thing& thing, const world::DrawableSnapshot& drawable, const world::AgentSnapshot* agent, bool agent_body);
  /// Creates and poses a thing with a skeleton.
  void ShowBody(Thing& thing, const world::BodyMesh& mesh, const world::DrawableSnapshot& drawable,
                const world::DrawableSnapshot* before, float blend, const world::AgentSnapshot* agent);
  /// The same for a model that moves.
  void ShowModel(Thing& thing, std::shared_ptr<const model::Model> model, const world::DrawableSnapshot& drawable,
                 const world::DrawableSnapshot* before, float blend);
  /// Advances the feet to the newest tick.
  void HoldFeet(Thing& thing, const world::DrawableSnapshot& drawable, const world::DrawableSnapshot* before);
  InstanceBatch& BatchOf(const Ogre::MeshPtr& mesh, const Materials::Found& material, bool is_ground);
  InstanceBatch& BodiesOf(const Thing& thing, BodyDetail detail);
  InstanceBatch& ModelsOf(const std::shared_ptr<const model::Model>& model);
  void AddThing(Thing& thing, const Sight& sight) const;
  void AddBodies(const Sight& sight);
  void AddModels(const Sight& sight);
  /// Whether the body is in the picture, or may cast a shadow into it.
  bool MattersTo(const Sight& sight, const Thing& thing) const;
  void AddSkeletonLines(const world::Skeleton& skeleton, const world::BonePose& model,
                        const std::vector<world::BonePose>& bones);
  void Undress(Thing& thing);

  Ogre::SceneManager& scene_;
  Materials& materials_;
  float reach_;
  MeshLibrary meshes_;
  BodyLibrary bodies_;
  BoneTexture bones_;
  OnWarning on_warning_;
  std::unordered_map<std::uint32_t, Thing> things_;
  std::vector<Thing*> shown_, bodies_shown_, models_shown_;  ///< Things of the newest snapshot, in its order.
  std::map<std::pair<std::string, std::string>, std::unique_ptr<InstanceBatch>> batches_;  ///< By mesh and material.
  using BodyKey = std::tuple<world::BodyLook, BodyDetail, std::string>;
  std::map<BodyKey, std::unique_ptr<InstanceBatch>> body_batches_;
  std::map<std::shared_ptr<const model::Model>, std::unique_ptr<InstanceBatch>> model_batches_;
  std::unordered_map<std::uint32_t, const world::AgentSnapshot*> agents_;
  std::vector<world::LineSnapshot> skeleton_lines_;
  std::set<std::string> warned_;
  std::uint64_t update_count_ = 0;
  std::uint64_t tick_ = 0;
  double time_s_ = 0, tick_s_ = 0;  ///< Of the newest snapshot; and the time between it and the previous one.
  world::Vec3 sunlight_{0.4f, -0.8f, 0.45f};
};

}  // namespace soarbox::viewer
