// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/math.h"

namespace soarbox::sim {

// Directions on the ground: 0 degrees is along z, 90 along x. That is to the left of an agent that faces along z.

inline world::Vec3 Flat(world::Vec3 v) {
  return {v.x, 0, v.z};
}
inline float FlatDistance(world::Vec3 a, world::Vec3 b) {
  return world::Length(Flat(b - a));
}
inline float HeadingOf(world::Vec3 direction) {
  return std::atan2(direction.x, direction.z) * 180 / std::numbers::pi_v<float>;
}
inline world::Vec3 AlongHeading(float degrees) {
  const float radians = degrees * std::numbers::pi_v<float> / 180;
  return {std::sin(radians), 0, std::cos(radians)};
}
/// The same angle in (-180, 180].
inline float WrapDegrees(float degrees) {
  if (!(std::abs(degrees) < 360)) degrees = std::fmod(degrees, 360.0f);
  if (degrees > 180) degrees -= 360;
  return degrees <= -180 ? degrees + 360 : degrees;
}
/// The direction to a point relative to `forward`, for an observer at `from`; positive to the left.
inline float BearingOf(world::Vec3 from, world::Vec3 forward, world::Vec3 to) {
  return WrapDegrees(HeadingOf(to - from) - HeadingOf(forward));
}
/// Returns a number that rounds to the same integer as BearingOf, at a sixth of its cost. Calls BearingOf if the result
/// is close to a half.
inline float BearingToRound(world::Vec3 from, world::Vec3 forward, world::Vec3 to) {
  const world::Vec3 way = to - from;
  const float along = way.x * forward.x + way.z * forward.z, across = way.x * forward.z - way.z * forward.x;
  const float more = std::max(std::abs(along), std::abs(across)), less = std::min(std::abs(along), std::abs(across));
  constexpr float kLeast = 1e-6f;
  if (more > kLeast) {
    // Arc tangent of 0 to 1, in degrees: a polynomial through six points, with an error below 0.0002.
    const float ratio = less / more, t = ratio * ratio;
    const float arc =
        ratio *
        (57.2954836f + t * (-19.0770372f + t * (11.1925352f + t * (-6.9011956f + t * (3.2423673f + t * -0.7523155f)))));
    const float from_along = std::abs(across) > std::abs(along) ? 90 - arc : arc;
    const float degrees = along < 0 ? 180 - from_along : from_along;
    constexpr float kUnsure_deg = 0.01f;
    const float past_half = degrees - static_cast<float>(static_cast<int>(degrees)) - 0.5f;
    if (std::abs(past_half) > kUnsure_deg && degrees < 179) return std::copysign(degrees, across);
  }
  return BearingOf(from, forward, to);
}

}  // namespace soarbox::sim
