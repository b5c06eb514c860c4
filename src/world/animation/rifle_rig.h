// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/animation/bone_pose.h"

namespace soarbox::world {

/// The rifle's bones, by index.
enum RifleBone : int { kRifleBody, kRifleBarrel, kRifleMuzzle, kRifleMagazine, kRifleBolt, kRifleStock, kRifleBones };

/// Positions in the rifle, in m from the middle of its grip (barrel +x, up +y, right +z).
struct RifleSize {
  static constexpr float kBore = 0.075f;   ///< Height of the barrel.
  static constexpr float kMuzzle = 0.64f;  ///< End of the extended barrel.
  static constexpr float kButt = -0.27f;
  static constexpr float kRetracts = 0.20f;  ///< Length by which the barrel retracts for the short form.
  static constexpr Vec3 kMagazine{0.125f, 0.01f, 0};
};

}  // namespace soarbox::world
