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
#include "viewer/body_batch.h"
#include "viewer/foot_plant.h"
#include "viewer/materials.h"
#include "viewer/mesh_library.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// Keeps one Ogre entity per visible drawable of the snapshot, by its id, and moves it.
class SceneView {
 public:
  using OnWarning = std::function<void(const Diagnostic&)>;
  /// reach: bodies are drawn in detail so many times further away; below 1 on slow renderers.
  SceneView(Ogre::SceneManager& scene, Materials& materials, float reach, OnWarning on_warning);
  ~SceneView();
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  /// Creates, changes, moves and removes entities. With `previous`, bodies stand between the two by `blend`, 0..1.
  void Update(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend);

  /// Draws the bodies of the last Update for a camera: those who are far or many in less detail, that of the agent
  /// `inside` not at all. Before each frame.
  void PoseBodies(const world::CameraSnapshot& camera, std::uint32_t inside);

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
  struct Thing {
    Ogre::SceneNode* node = nullptr;
    Ogre::Entity* entity = nullptr;
    std::string mesh_name;
    std::string material_name;
    std::uint64_t seen = 0;
    std::unique_ptr<PosedBody> body;  ///< Of meshes with a skeleton; these have no entity.
    std::unique_ptr<Feet> feet;
    BodyDetail detail = BodyDetail::kFine;
    world::BodyLook look = world::BodyLook::kSoldier;
    bool visible = true;
    std::uint32_t agent = 0;  ///< Whose it is; 0: nobody's.
  };
  void Place(Thing& thing, const world::DrawableSnapshot& drawable, const world::DrawableSnapshot* before, float blend);
  void Dress(Thing& thing, const world::DrawableSnapshot& drawable, const world::AgentSnapshot* agent, bool agent_body);
  /// Dresses and poses what has a skeleton.
  void ShowBody(Thing& thing, const world::BodyMesh& mesh, const world::DrawableSnapshot& drawable,
                const world::DrawableSnapshot* before, float blend, const world::AgentSnapshot* agent);
  /// Brings the feet to the newest tick.
  void HoldFeet(Thing& thing, const world::DrawableSnapshot& drawable, const world::DrawableSnapshot* before);
  BodyBatch& BatchFor(const Thing& thing);
  void Wear(Thing& thing, const Ogre::MeshPtr& mesh, bool casts_shadows);
  void AddSkeletonLines(const world::Skeleton& skeleton, const world::BonePose& model,
                        const std::vector<world::BonePose>& bones);
  void Destroy(Thing& thing);

  Ogre::SceneManager& scene_;
  Materials& materials_;
  float reach_;
  MeshLibrary meshes_;
  BodyLibrary bodies_;
  OnWarning on_warning_;
  std::unordered_map<std::uint32_t, Thing> things_;
  std::vector<std::uint32_t> bodies_shown_;  ///< Things with a skeleton, in the order of the snapshot.
  using BatchKey = std::tuple<world::BodyLook, BodyDetail, std::string>;
  std::map<BatchKey, std::unique_ptr<BodyBatch>> batches_;
  std::unordered_map<std::uint32_t, const world::AgentSnapshot*> agents_;
  std::vector<world::LineSnapshot> skeleton_lines_;
  std::set<std::string> warned_;
  std::uint64_t update_count_ = 0;
  std::uint64_t tick_ = 0;
  double time_s_ = 0, tick_s_ = 0;  ///< Of the newest snapshot; between it and the one before.
};

}  // namespace soarbox::viewer
