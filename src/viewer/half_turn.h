// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <numbers>

namespace soarbox::viewer {

/// Half a turn, in radians.
inline constexpr float kPi = std::numbers::pi_v<float>;

}  // namespace soarbox::viewer
