// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/math.h"

namespace soarbox::sim {

// Directions on the ground: 0 degrees along z, 90 along x, which is to the left of an agent that faces along z.

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
/// Into (-180, 180].
inline float WrapDegrees(float degrees) {
  if (!(std::abs(degrees) < 360)) degrees = std::fmod(degrees, 360.0f);
  if (degrees > 180) degrees -= 360;
  return degrees <= -180 ? degrees + 360 : degrees;
}
/// Of a point, for somebody who stands at `from` and faces along `forward`; positive to the left.
inline float BearingOf(world::Vec3 from, world::Vec3 forward, world::Vec3 to) {
  return WrapDegrees(HeadingOf(to - from) - HeadingOf(forward));
}

}  // namespace soarbox::sim
