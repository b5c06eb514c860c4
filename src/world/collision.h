// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/ids.h"
#include "world/math.h"

namespace soarbox::world {

/// Two bodies that overlapped after the last step; one per pair of bodies and step. World coordinates.
/// For the callbacks of b, swap a and b and the points, and negate the normal (spec 4.3).
struct Collision {
  EntityId a = kNoEntity;
  EntityId b = kNoEntity;
  Vec3 point_a;      ///< On the surface of a.
  Vec3 point_b;      ///< On the surface of b.
  Vec3 normal_on_b;  ///< Unit; from b towards a.
};

/// What a ray met first.
struct RayHit {
  EntityId entity = kNoEntity;  ///< An agent or an object.
  Vec3 point;
  Vec3 normal;
};

}  // namespace soarbox::world
