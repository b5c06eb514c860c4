// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// A scene that resembles the world of the thesis: agents that walk in circles, a stack of blocks, walls, debug circles
/// and paths, and the help text of its sandbox script. Used by the picture test.
class DemoScene {
 public:
  /// With at most 6 agents.
  DemoScene(int agents, int width_px, int height_px);

  /// Returns the scene at a time; the same for the same arguments.
  world::SceneSnapshot At(double time_s) const;

 private:
  void AddGround(world::SceneSnapshot& scene) const;
  void AddBlocks(world::SceneSnapshot& scene) const;
  void AddAgents(world::SceneSnapshot& scene, double time_s) const;
  void AddText(world::SceneSnapshot& scene) const;
  void PlaceCamera(world::SceneSnapshot& scene) const;

  int agents_, width_, height_;
};

}  // namespace soarbox::viewer
