// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>

#include "world/math.h"

namespace soarbox::world {

/// Whether the triangle and the axis-aligned box around `center` intersect (separating axis test).
bool TriangleTouchesBox(const std::array<Vec3, 3>& triangle, Vec3 center, Vec3 half);

}  // namespace soarbox::world
