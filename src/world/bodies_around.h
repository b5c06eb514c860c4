// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <optional>

#include "world/collision.h"
#include "world/math.h"

namespace soarbox::world {

/// The bodies around a place, for many short rays there: each costs a fraction of World::RayCast where there are many
/// bodies. Valid until something moves, comes or goes.
class BodiesAround {
 public:
  struct Bodies;
  explicit BodiesAround(std::unique_ptr<const Bodies> bodies);
  BodiesAround(BodiesAround&&) noexcept;
  BodiesAround& operator=(BodiesAround&&) noexcept;
  ~BodiesAround();

  /// What World::RayCast answers, for segments within the reach that was asked for.
  std::optional<RayHit> RayCast(Vec3 from, Vec3 to) const;
  /// Whether RayCast would hit nothing, or one of these two. Cheaper where much is in the way.
  bool IsOpen(Vec3 from, Vec3 to, EntityId through, EntityId self) const;

 private:
  friend class PhysicsWorld;
  std::unique_ptr<const Bodies> bodies_;
};

}  // namespace soarbox::world
