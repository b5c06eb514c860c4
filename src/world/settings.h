// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "world/math.h"

namespace soarbox::world {

/// What a world is made with; fixed for its life. The defaults are those of the sandbox.
struct WorldSettings {
  std::uint64_t seed = 1;       ///< Of the world's random stream and, mixed with their ids, of the agents' streams.
  float step_s = 1.0f / 30.0f;  ///< Physics advances by this much per tick; 0.001 to 0.1.
  Vec3 gravity{0, -9.8f, 0};    ///< m/s^2
  int solver_iterations = 10;
  int screen_width_px = 1280;  ///< What scripts see until a window says otherwise.
  int screen_height_px = 800;
};

/// The constants of a new agent. Copied into the agent; scripts change the agent's own.
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
