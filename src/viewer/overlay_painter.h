// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bitset>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "viewer/viewer.h"

namespace soarbox::viewer {

/// Input of the overlays of a frame.
struct OverlayScene {
  const std::vector<world::AgentSnapshot>& agents;  ///< At the positions where they are drawn.
  const world::OverlaySnapshot& overlays;
  const std::vector<std::uint32_t>& selection;
  const std::bitset<kViewerCommands>& on;
  std::uint32_t inside = 0;  ///< The agent through whose eyes the camera looks; 0: none.
};

/// The shapes that the overlays add to a frame.
struct OverlayMarks {
  std::vector<world::LineSnapshot> lines;
  std::vector<world::TriangleSnapshot> triangles;
  std::vector<Ghost> ghosts;
};

/// Adds a ring under each ghost, and a dashed line from the ghost to its agent.
void PaintGhostThreads(const std::vector<Ghost>& ghosts, const std::vector<world::AgentSnapshot>& agents,
                       OverlayMarks& marks);

/// Converts the data of overlays to lines, fills and ghosts over the scene. It only computes; it draws nothing.
class OverlayPainter {
 public:
  /// Notes the positions of all agents. Call it with each new snapshot, whether overlays are on or off.
  void Note(const world::SceneSnapshot& newest);

  void Paint(const OverlayScene& scene, OverlayMarks& marks) const;

 private:
  struct Course {
    std::deque<world::Vec3> points;  ///< Positions of its feet, newest last.
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
