// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::world {

/// Whom a navigation mesh is made for, and how fine it is. The defaults suit a new agent.
struct NavigationConfig {
  float walkable_height_m = 1.6f;    ///< Free height that an agent needs; above 0, at most 100.
  float walkable_radius_m = 0.375f;  ///< Distance kept from walls and ledges; 0 to 50.
  float climb_height_m = 0.15f;      ///< The highest step that an agent takes; 0 to 50.
  float slope_deg = 45;              ///< The steepest walkable slope; 0 to 90.
  float min_region_cells = 50;       ///< Smaller islands are dropped: the side of a square, in cells; 0 to 10000.
  float merge_region_cells = 100;    ///< Smaller regions join their neighbours: the side of a square, in cells.
  float cell_size_m = 0.1f;          ///< Side of a cell, and the step of heights; 0.05 to 10.
  bool keeps_points = false;         ///< FindClosestPoint answers with its argument, as the first sandbox did.
};

}  // namespace soarbox::world
