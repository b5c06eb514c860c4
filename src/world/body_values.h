// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::world {

/// A valid size or mass of a body, and a message if another value was requested.
struct BodyValue {
  float value = 0;      ///< The value to use.
  std::string problem;  ///< "a width of -3 m is not possible: 0.001 m is used"; empty if the value was
                        ///< valid.
};

/// Clamps a size to a millimetre to 100 km. NaN is replaced by the minimum. `what`: "width", "radius".
BodyValue BodySize(std::string_view what, float metres);
/// Clamps a mass to 0 (fixed) to a million tonnes. NaN is replaced by 0.
BodyValue BodyMass(float kg);

}  // namespace soarbox::world
