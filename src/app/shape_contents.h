// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_set>
#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::app {

/// What bodies and things look like, as contents for pages: the window's own shapes, each told once when a scene first
/// shows it (docs/dev/stream.md#shapes).
class ShapeContents {
 public:
  struct Told {
    std::string name;  ///< "shapes:KEY"
    nlohmann::ordered_json content;
  };
  /// Shapes that the scene shows and that were not told yet.
  std::vector<Told> New(const world::SceneSnapshot& scene);

  /// Of so many shapes a page is told: scripts may change the size of a box in each tick. What comes later is not
  /// drawn.
  static constexpr std::size_t kMost = 4000;

 private:
  std::unordered_set<std::string> told_;
};

/// How a drawable's shape is called: the same for all that look alike. `agent_body`: a capsule that looks like an
/// agent.
std::string ShapeKey(const world::DrawableSnapshot& drawable, bool agent_body);

}  // namespace soarbox::app
