// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "world/math.h"

namespace soarbox::stream {

inline constexpr double kPerMetre = 1000, kPerRadian = 2048, kBonePerRadian = 256, kBonePerMetre = 250,
                        kPerDirection = 500;

/// Rounds a value to steps, at most 2^30 in both directions; 0 for values that are not finite.
inline std::int32_t Steps(float value, double per_unit) {
  constexpr double kMost = 1 << 30;
  const double steps = static_cast<double>(value) * per_unit;
  if (!std::isfinite(steps)) return 0;
  return static_cast<std::int32_t>(std::lround(std::fmin(std::fmax(steps, -kMost), kMost)));
}
inline std::array<std::int32_t, 3> Steps(world::Vec3 value, double per_unit) {
  return {Steps(value.x, per_unit), Steps(value.y, per_unit), Steps(value.z, per_unit)};
}

/// The same, but keeps the earlier step if the value has changed only slightly, so that it does not flicker between two
/// steps.
inline std::array<std::int32_t, 3> SteadySteps(world::Vec3 value, double per_unit,
                                               const std::array<std::int32_t, 3>& before) {
  constexpr double kStays = 0.8;
  std::array<std::int32_t, 3> steps = Steps(value, per_unit);
  const float parts[] = {value.x, value.y, value.z};
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(static_cast<double>(parts[i]) * per_unit - before[i]) < kStays) steps[i] = before[i];
  }
  return steps;
}

/// A rotation as its axis times its angle, 0 to pi.
inline world::Vec3 TurnVector(world::Quat turn) {
  if (turn.w < 0) turn = {-turn.w, -turn.x, -turn.y, -turn.z};
  const world::Vec3 axis{turn.x, turn.y, turn.z};
  const float sine = world::Length(axis);
  if (!(sine > 1e-9f)) return {};
  return axis * (2 * std::atan2(sine, turn.w) / sine);
}

}  // namespace soarbox::stream
