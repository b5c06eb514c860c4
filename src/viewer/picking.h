// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

struct ScreenPoint {
  float x = 0, y = 0;  ///< px from the top left.
};

/// The camera's projection: the ray through a pixel, the position of a point in the picture, and the agent under the
/// cursor. It only computes; it draws nothing.
class Projection {
 public:
  Projection(const world::CameraSnapshot& camera, int width_px, int height_px);

  /// Unit direction from the camera through a pixel.
  world::Vec3 RayThrough(ScreenPoint pixel) const;

  /// Returns the position of a point in the picture; nothing for points behind the camera.
  std::optional<ScreenPoint> Project(world::Vec3 point) const;

  /// Returns the nearest agent under a pixel, with some tolerance for small, distant ones; 0 if there is none.
  std::uint32_t AgentAt(ScreenPoint pixel, const std::vector<world::AgentSnapshot>& agents) const;
  /// Returns the agents whose centre is in the box between two corners, in the order of `agents`.
  std::vector<std::uint32_t> AgentsIn(ScreenPoint from, ScreenPoint to,
                                      const std::vector<world::AgentSnapshot>& agents) const;

 private:
  world::Vec3 eye_, forward_, right_, up_;
  float width_, height_;
  float pixels_per_slope_;  ///< Pixels from the centre for a slope of 1.
};

}  // namespace soarbox::viewer
