// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "world/entity_ids.h"
#include "world/math.h"

namespace soarbox::world {

class PhysicsWorld;

/// An agent that searches for a free path.
struct Walker {
  Vec3 place;              ///< Bodies block it at the height of this position.
  float half_width_m = 0;  ///< Half the width of the path that it needs.
  EntityId self = kNoEntity;
  EntityId through = kNoEntity;  ///< Another body that does not block it.
};

/// The free horizontal paths of a walker among the bodies around it. Valid until a body moves, is added or is removed.
class WaysAround {
 public:
  /// `reach_m`: length of the longest path, including its width.
  WaysAround(const PhysicsWorld& physics, const Walker& walker, float reach_m);
  WaysAround(WaysAround&&) noexcept;
  WaysAround& operator=(WaysAround&&) noexcept;
  ~WaysAround();

  /// Whether a path of this length and direction is free. It casts rays in `direction` (a horizontal unit vector, or
  /// zero) from the walker's position and from half its width to the left and right. Each ray must hit nothing, or
  /// first one of the walker's two bodies. `length_m` plus the width must be within reach_m.
  bool IsOpen(Vec3 direction, float length_m) const;

 private:
  struct Ways;
  std::unique_ptr<Ways> ways_;  ///< Null if a number is not finite.
};

}  // namespace soarbox::world
