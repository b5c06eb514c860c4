// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::world {

/// The size of the agents for which a navigation mesh is built, and its resolution. The defaults suit a new agent.
struct NavigationConfig {
  float walkable_height_m = 1.6f;    ///< Free height that an agent needs; above 0, at most 100.
  float walkable_radius_m = 0.375f;  ///< Distance to walls and ledges; 0 to 50.
  float climb_height_m = 0.15f;      ///< Maximum height of a step; 0 to 50.
  float slope_deg = 45;              ///< Maximum walkable slope; 0 to 90.
  float min_region_cells = 50;       ///< Islands smaller than a square of this side, in cells, are dropped; 0 to 10000.
  float merge_region_cells = 100;    ///< Regions smaller than a square of this side, in cells, are merged with their
                                     ///< neighbours.
  float cell_size_m = 0.1f;          ///< Side of a cell, and vertical resolution; 0.05 to 10.
  bool keeps_points = false;         ///< FindClosestPoint returns its argument, as in the first sandbox.
};

}  // namespace soarbox::world
