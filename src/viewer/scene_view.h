// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <set>
#include <string>
#include <unordered_map>

#include "diagnostics/diagnostic.h"
#include "viewer/materials.h"
#include "viewer/mesh_library.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// Keeps one Ogre entity per visible drawable of the snapshot, by its id, and moves it.
class SceneView {
 public:
  using OnWarning = std::function<void(const Diagnostic&)>;
  SceneView(Ogre::SceneManager& scene, Materials& materials, OnWarning on_warning);

  /// Creates, changes, moves and removes entities. With `previous`, bodies stand between the two by `blend`, 0..1.
  void Update(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend);

  /// Warns once per name that something is missing and what is shown instead.
  void WarnOnce(const std::string& kind, const std::string& name, const std::string& instead);

 private:
  struct Thing {
    Ogre::SceneNode* node = nullptr;
    Ogre::Entity* entity = nullptr;
    std::string mesh_name;
    std::string material_name;
    std::uint64_t seen = 0;
  };
  void Place(Thing& thing, const world::DrawableSnapshot& drawable, const world::DrawableSnapshot* before, float blend);
  void Dress(Thing& thing, const world::DrawableSnapshot& drawable, const world::AgentSnapshot* agent, bool agent_body);
  void Destroy(Thing& thing);

  Ogre::SceneManager& scene_;
  Materials& materials_;
  MeshLibrary meshes_;
  OnWarning on_warning_;
  std::unordered_map<std::uint32_t, Thing> things_;
  std::unordered_map<std::uint32_t, const world::AgentSnapshot*> agents_;
  std::unordered_map<std::uint32_t, const world::DrawableSnapshot*> before_;
  std::set<std::string> warned_;
  std::uint64_t update_count_ = 0;
};

}  // namespace soarbox::viewer
