// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <optional>

#include "world/collision.h"
#include "world/math.h"

namespace soarbox::world {

class PhysicsWorld;

/// The area that an observer looks at from a position. Its height is not limited.
struct View {
  Vec3 place;
  float range_m = 0;      ///< On the ground.
  Vec3 forward;           ///< Zero: all directions.
  float angle_deg = 360;  ///< Field of view from side to side, centred on forward.
};

/// The bodies that may block the view, for many lines of sight from the same position. Valid until a body moves, is
/// added or is removed.
class BodiesAround {
 public:
  BodiesAround(const PhysicsWorld& physics, const View& view);
  BodiesAround(BodiesAround&&) noexcept;
  BodiesAround& operator=(BodiesAround&&) noexcept;
  ~BodiesAround();

  /// Like World::RayCast, from the view's position to a point in the view.
  std::optional<RayHit> RayCast(Vec3 from, Vec3 to) const;
  /// Whether RayCast finds nothing, or a body of one of these two. Costs less than RayCast.
  bool MeetsNoOther(Vec3 from, Vec3 to, EntityId viewer, EntityId target) const;

 private:
  friend class PhysicsWorld;
  struct Bodies;
  std::unique_ptr<const Bodies> bodies_;
};

}  // namespace soarbox::world
