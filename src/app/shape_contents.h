// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_set>
#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::app {

/// Contents for pages: the shapes of bodies and things ("shapes:KEY", the same as in the window), and the images and
/// sounds that scripts show and play ("assets:KEY"). Each is sent once, when a scene first needs it
/// (docs/dev/stream.md#shapes).
class ShapeContents {
 public:
  struct Told {
    std::string name;  ///< "shapes:KEY" or "assets:KEY"
    nlohmann::ordered_json content;
  };
  /// Shapes and files that the scene shows or plays and that were not sent yet.
  std::vector<Told> New(const world::SceneSnapshot& scene);

  /// Maximum number of shapes sent to a page, because scripts may change the size of a box in each tick. Further shapes
  /// are not drawn.
  static constexpr std::size_t kMost = 4000;

 private:
  void AddAssets(const world::SceneSnapshot& scene, std::vector<Told>& found);

  std::unordered_set<std::string> told_;
};

/// The key of a drawable's shape: the same for all that look alike. `agent_body`: a capsule with the shape of an agent.
std::string ShapeKey(const world::DrawableSnapshot& drawable, bool agent_body);

}  // namespace soarbox::app
