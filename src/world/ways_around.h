// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "world/ids.h"
#include "world/math.h"

namespace soarbox::world {

class PhysicsWorld;

/// Who looks for a way.
struct Walker {
  Vec3 place;              ///< The height at which bodies are in its way is that of the place.
  float half_width_m = 0;  ///< Of the way that it needs.
  EntityId self = kNoEntity;
  EntityId through = kNoEntity;  ///< Another body that is not in its way.
};

/// The ways that are open for a walker among the bodies around it. Valid until something moves, comes or goes.
class WaysAround {
 public:
  /// `reach_m`: of the longest way, its width included.
  WaysAround(const PhysicsWorld& physics, const Walker& walker, float reach_m);
  WaysAround(WaysAround&&) noexcept;
  WaysAround& operator=(WaysAround&&) noexcept;
  ~WaysAround();

  /// Whether World::RayCast would hit nothing, or one of the walker's two bodies first, from its place and from half
  /// its width to the left and right of it, each time so far in that direction: a level unit vector, or zero. The
  /// length: with the width within the reach that was asked for.
  bool IsOpen(Vec3 direction, float length_m) const;

 private:
  struct Ways;
  std::unique_ptr<Ways> ways_;  ///< Null if a number is not finite.
};

}  // namespace soarbox::world
