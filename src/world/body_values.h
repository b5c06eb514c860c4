// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::world {

/// A size or a mass that a body can have, and what to say to whoever asked for another.
struct BodyValue {
  float value = 0;      ///< What the body gets.
  std::string problem;  ///< "a width of -3 m is none that a body can have: 0.001 m is taken"; empty if all is well.
};

/// From a millimetre to 100 km. Less, and what is not a number, becomes the least. `what`: "width", "radius".
BodyValue BodySize(std::string_view what, float metres);
/// 0 (fixed) to a million tonnes. Less, and what is not a number, becomes 0.
BodyValue BodyMass(float kg);

}  // namespace soarbox::world
