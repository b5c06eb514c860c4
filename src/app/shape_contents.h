// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_set>
#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::app {

/// What bodies and things look like, and the images and sounds that scripts show and play (as "assets:KEY"), as
/// contents for pages: the window's own shapes, each told once when a scene first shows it (docs/dev/stream.md#shapes).
class ShapeContents {
 public:
  struct Told {
    std::string name;  ///< "shapes:KEY" or "assets:KEY"
    nlohmann::ordered_json content;
  };
  /// Shapes and files that the scene shows or plays and that were not told yet.
  std::vector<Told> New(const world::SceneSnapshot& scene);

  /// Of so many shapes a page is told: scripts may change the size of a box in each tick. What comes later is not
  /// drawn.
  static constexpr std::size_t kMost = 4000;

 private:
  void AddAssets(const world::SceneSnapshot& scene, std::vector<Told>& found);

  std::unordered_set<std::string> told_;
};

/// How a drawable's shape is called: the same for all that look alike. `agent_body`: a capsule that looks like an
/// agent.
std::string ShapeKey(const world::DrawableSnapshot& drawable, bool agent_body);

}  // namespace soarbox::app
