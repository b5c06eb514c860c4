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

/// Keeps what is known of each visible drawable of the snapshot, by its id, and draws it: alike things of one material
/// in one draw call each (instance_batch.h), what is see-through as an Ogre entity of its own.
class SceneView {
 public:
  using OnWarning = std::function<void(const Diagnostic&)>;
  /// reach: bodies are drawn in detail so many times further away; below 1 on slow renderers.
  SceneView(Ogre::SceneManager& scene, Materials& materials, float reach, OnWarning on_warning);
  ~SceneView();
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  /// Takes over what is new, changed, moved or gone. With `previous`, bodies stand between the two by `blend`,
  /// 0..1.
  void Update(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend);

  /// Draws the things of the last Update for a camera, whose picture is `height_px` high: those that are small in it or
  /// many in less detail, those of the agent `inside` not at all. Before each frame; EndFrame after it.
  void BeginFrame(const Ogre::Camera& camera, int height_px, std::uint32_t inside);
  void EndFrame();
  /// Of the frame that has begun.
  BoneTexture& bones() { return bones_; }

  /// The body of an agent as it stands now, without what it carries; none if it has none with a skeleton.
  struct Figure {
    world::BodyLook look;
    const PosedBody* body;
  };
  std::optional<Figure> FigureOf(std::uint32_t agent) const;

  /// The bones that scripts want to see, of the bodies as they stood at the last Update.
  const std::vector<world::LineSnapshot>& skeleton_lines() const { return skeleton_lines_; }

  /// Warns once per name that something is missing and what is shown instead.
  void WarnOnce(const std::string& kind, const std::string& name, const std::string& instead);

 private:
  /// The feet of an agent's soldier, and its bones at the last two ticks with the feet held.
  struct Feet {
    FootPlant plant;
    std::uint64_t tick = 0;
    std::vector<world::BonePose> before, now;
  };
  /// Of what a thing's looks were made. `kind` and the rest: of agents whose colour it has.
  struct Clothes {
    world::ShapeKind shape = world::ShapeKind::kMesh;
    world::Vec3 size, texture_repeats;
    world::Shared<std::string> mesh, material;
    std::string kind;
    bool is_body = false, alive = true, failed = false;
    bool operator==(const Clothes&) const = default;
  };
  struct Thing {
    std::optional<Clothes> clothes;      ///< None: not dressed yet.
    Ogre::SceneNode* node = nullptr;     ///< Of what is see-through.
    Ogre::Entity* entity = nullptr;      ///< Likewise.
    std::vector<InstanceBatch*> levels;  ///< Of what is not: the finest first.
    float radius_m = 0;                  ///< Around its origin, unless it is scaled.
    float height_m = 0;
    world::Vec3 position, scale{1, 1, 1};
    world::Quat orientation;
    std::uint64_t seen = 0;
    std::unique_ptr<PosedBody> body;  ///< Of meshes with a skeleton; these have neither entity nor levels.
    std::unique_ptr<Feet> feet;
    std::size_t detail = 0;  ///< Which level it was drawn in.
    world::BodyLook look = world::BodyLook::kSoldier;
    std::string material;  ///< Of bodies; empty: what soldiers wear.
    world::Color trim;     ///< Of those.
    bool visible = true;
    std::uint32_t agent = 0;  ///< Whose it is; 0: nobody's.
  };
  /// What a frame is drawn for.
  struct Sight {
    const Ogre::Camera& camera;
    Ogre::Vector3 eye;
    float px_per_m;        ///< Of something one metre away.
    float light_per_m;     ///< How far along the sun's light shadows matter, for each metre above the ground.
    std::uint32_t inside;  ///< Nobody's things: 0.
  };
  void Place(Thing& thing, const world::DrawableSnapshot& drawable, const world::DrawableSnapshot* before, float blend);
  void Dress(Thing& thing, const world::DrawableSnapshot& drawable, const world::AgentSnapshot* agent, bool agent_body);
  /// Dresses and poses what has a skeleton.
  void ShowBody(Thing& thing, const world::BodyMesh& mesh, const world::DrawableSnapshot& drawable,
                const world::DrawableSnapshot* before, float blend, const world::AgentSnapshot* agent);
  /// Brings the feet to the newest tick.
  void HoldFeet(Thing& thing, const world::DrawableSnapshot& drawable, const world::DrawableSnapshot* before);
  InstanceBatch& BatchOf(const Ogre::MeshPtr& mesh, const Materials::Found& material, bool is_ground);
  InstanceBatch& BodiesOf(const Thing& thing, BodyDetail detail);
  void AddThing(Thing& thing, const Sight& sight) const;
  void AddBodies(const Sight& sight);
  /// Whether the body is in the picture, or might throw its shadow into it.
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
  std::vector<Thing*> shown_, bodies_shown_;  ///< Those of the newest snapshot, in its order.
  std::map<std::pair<std::string, std::string>, std::unique_ptr<InstanceBatch>> batches_;  ///< By mesh and material.
  using BodyKey = std::tuple<world::BodyLook, BodyDetail, std::string>;
  std::map<BodyKey, std::unique_ptr<InstanceBatch>> body_batches_;
  std::unordered_map<std::uint32_t, const world::AgentSnapshot*> agents_;
  std::vector<world::LineSnapshot> skeleton_lines_;
  std::set<std::string> warned_;
  std::uint64_t update_count_ = 0;
  std::uint64_t tick_ = 0;
  double time_s_ = 0, tick_s_ = 0;  ///< Of the newest snapshot; between it and the one before.
  world::Vec3 sunlight_{0.4f, -0.8f, 0.45f};
};

}  // namespace soarbox::viewer
