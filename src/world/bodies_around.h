// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <optional>

#include "world/collision.h"
#include "world/math.h"

namespace soarbox::world {

class PhysicsWorld;

/// What somebody may look at from a place: whatever is above or below.
struct View {
  Vec3 place;
  float range_m = 0;      ///< On the ground.
  Vec3 forward;           ///< Zero: it looks to all sides.
  float angle_deg = 360;  ///< From side to side, about forward.
};

/// The bodies that may hide something in a view, for many lines of sight there. Valid until something moves, comes or
/// goes.
class BodiesAround {
 public:
  BodiesAround(const PhysicsWorld& physics, const View& view);
  BodiesAround(BodiesAround&&) noexcept;
  BodiesAround& operator=(BodiesAround&&) noexcept;
  ~BodiesAround();

  /// World::RayCast from the view's place to one within the view.
  std::optional<RayHit> RayCast(Vec3 from, Vec3 to) const;

 private:
  friend class PhysicsWorld;
  struct Bodies;
  std::unique_ptr<const Bodies> bodies_;
};

}  // namespace soarbox::world
