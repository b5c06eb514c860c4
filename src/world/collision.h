// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/entity_ids.h"
#include "world/math.h"

namespace soarbox::world {

/// Two bodies that overlapped after the last step. There is one entry per pair and step, in world coordinates. For the
/// callbacks of b, swap a and b and the points, and negate the normal (lua_api.md 4.3).
struct Collision {
  EntityId a = kNoEntity;
  EntityId b = kNoEntity;
  Vec3 point_a;      ///< On the surface of a.
  Vec3 point_b;      ///< On the surface of b.
  Vec3 normal_on_b;  ///< Unit; from b towards a.
};

/// A body entered or left a sensor in the last step.
struct SensorChange {
  EntityId sensor = kNoEntity;
  EntityId other = kNoEntity;  ///< The agent or object. If it left, it may have been removed since.
  bool entered = false;
};

/// A hinge: an object turns about an axis that is fixed in the world, or in another object.
struct HingeDef {
  Vec3 point;                       ///< On the axis.
  Vec3 axis;                        ///< Not zero.
  float low_deg = 1, high_deg = 0;  ///< Limits of the turn from its present orientation; low > high: no limits.
  float friction_nm = 0;            ///< Maximum torque that brakes it.
};

/// The first body that a ray hits.
struct RayHit {
  EntityId entity = kNoEntity;  ///< An agent or an object.
  Vec3 point;
  Vec3 normal;
};

}  // namespace soarbox::world
