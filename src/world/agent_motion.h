// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "world/math.h"

namespace soarbox::world {

/// Position and motion of an agent, as steering uses them. Invariants: forward, left and up are the rotated z, x and y
/// axes; speed is the horizontal length of velocity, or the stored speed of an agent without a body.
///
/// The members that other agents read in each step come first and fit in one cache line.
struct alignas(64) AgentMotion {
  Vec3 position;
  Vec3 velocity;  ///< m/s
  Vec3 forward{0, 0, 1};
  float speed = 0;         ///< m/s
  float radius = 0;        ///< m
  bool alive = true;       ///< Health above 0.
  bool gone = false;       ///< It was removed; no query returns it.
  std::uint32_t team = 0;  ///< Its number (TeamNumbers).
  Vec3 left{1, 0, 0};
  Vec3 up{0, 1, 0};
  Quat orientation;
};

}  // namespace soarbox::world
