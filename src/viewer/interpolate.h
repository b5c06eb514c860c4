// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>

#include "world/math.h"
#include "world/rotation.h"

namespace soarbox::viewer {

/// Interpolation between two ticks: linear for positions, the shorter way for orientations. A body that moved further
/// than kJump_m in a tick was placed there. It is drawn at its new position at once.

inline constexpr float kJump_m = 4;

inline world::Vec3 BetweenPositions(world::Vec3 from, world::Vec3 to, float blend) {
  if (world::LengthSquared(to - from) > kJump_m * kJump_m) return to;
  return from + (to - from) * blend;
}

inline world::Quat BetweenOrientations(world::Quat from, world::Quat to, float blend) {
  const float dot = from.w * to.w + from.x * to.x + from.y * to.y + from.z * to.z;
  const float a = 1 - blend, b = dot < 0 ? -blend : blend;
  const world::Quat q{a * from.w + b * to.w, a * from.x + b * to.x, a * from.y + b * to.y, a * from.z + b * to.z};
  const float length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return length > 1e-6f ? world::Quat{q.w / length, q.x / length, q.y / length, q.z / length} : to;
}

}  // namespace soarbox::viewer
