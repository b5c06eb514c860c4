// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bitset>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "viewer/viewer.h"

namespace soarbox::viewer {

/// The part of a frame that overlays are drawn from.
struct OverlayScene {
  const std::vector<world::AgentSnapshot>& agents;  ///< Where they are drawn.
  const world::OverlaySnapshot& overlays;
  const std::vector<std::uint32_t>& selection;
  const std::bitset<kViewerCommands>& on;
  std::uint32_t inside = 0;  ///< The agent whose eyes the camera looks out of; 0: none.
};

/// What the overlays add to a frame.
struct OverlayMarks {
  std::vector<world::LineSnapshot> lines;
  std::vector<world::TriangleSnapshot> triangles;
  std::vector<Ghost> ghosts;
};

/// A ring under each ghost, and a dashed line from there to where its agent is.
void PaintGhostThreads(const std::vector<Ghost>& ghosts, const std::vector<world::AgentSnapshot>& agents,
                       OverlayMarks& marks);

/// Turns what is known of the agents into lines, fills and figures over the scene. Plain arithmetic, no drawing.
class OverlayPainter {
 public:
  /// Notes where everybody is; call it with each new snapshot, whether overlays are on or off.
  void Note(const world::SceneSnapshot& newest);

  void Paint(const OverlayScene& scene, OverlayMarks& marks) const;

 private:
  struct Course {
    std::deque<world::Vec3> points;  ///< Of its feet, the newest last.
    world::Vec3 velocity;
    world::Vec3 acceleration;  ///< m/s²
    std::uint64_t seen = 0;
  };

  void PaintTrails(const OverlayScene& scene, OverlayMarks& marks) const;
  void PaintForces(const OverlayScene& scene, OverlayMarks& marks) const;

  std::unordered_map<std::uint32_t, Course> courses_;
  std::uint64_t tick_ = 0;
  double time_s_ = -1;
};

}  // namespace soarbox::viewer
