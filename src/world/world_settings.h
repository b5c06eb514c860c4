// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "world/math.h"

namespace soarbox::world {

/// The settings of a world, which are fixed during its life. The defaults are those of the sandbox.
struct WorldSettings {
  std::uint64_t seed = 1;       ///< Seed of the world's random stream and, combined with their ids, of the agents'
                                ///< streams.
  float step_s = 1.0f / 30.0f;  ///< Simulated time per tick; 0.001 to 0.1.
  Vec3 gravity{0, -9.8f, 0};    ///< m/s^2
  int solver_iterations = 10;
  int screen_width_px = 1280;  ///< Reported to scripts until a window sets the size.
  int screen_height_px = 800;
};

/// The properties of a new agent. They are copied; scripts change the copy.
struct AgentDefaults {
  float height_m = 1.6f;  ///< Total height of the capsule.
  float radius_m = 0.3f;
  float mass_kg = 90.7f;
  float max_force_n = 1000;
  float max_speed_mps = 7;
  float health = 100;
  float target_radius_m = 0.5f;
};

}  // namespace soarbox::world
