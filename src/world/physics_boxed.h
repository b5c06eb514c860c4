// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "world/physics_bullet.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// A body with its bounding box in the broadphase, outside of which rays do not find it, and with its extent seen from
/// above.
struct BoxedBody {
  btDbvtVolume box;
  const btCollisionObject* body = nullptr;
  btScalar x = 0, z = 0, radius = 0;  ///< A circle that contains the body, seen from above.
  /// For an upright capsule: the vertical range of the ends of its axis. The capsule fills its entire circle between
  /// them and has hemispheres above and below. low > high for other bodies, and if the box is not up to date.
  btScalar low = 1, high = 0;

  bool IsPillar() const { return low <= high; }
};

/// Whether the body is exactly upright.
inline bool Stands(const btCollisionObject& body) {
  return body.getWorldTransform().getBasis()[1][1] == 1;
}

/// An upper bound of the rounding errors of distances near `place`. Results closer to a limit than this are not
/// certain. `reach_m`: maximum distance of the bodies that are tested.
inline btScalar SlackAbout(const btVector3& place, btScalar reach_m) {
  constexpr btScalar kLeast_m = 0.005f, kShare = 4e-6f;
  return kLeast_m + kShare * (std::abs(place.x()) + std::abs(place.y()) + std::abs(place.z()) + 4 * reach_m);
}

/// A static plane in world coordinates.
struct WorldPlane {
  btVector3 normal;
  btScalar constant;
  /// Distance from the plane in metres; negative on its back.
  btScalar HeightOf(const btVector3& place) const { return normal.dot(place) - constant; }
};

/// Nothing if the body is not a plane.
inline std::optional<WorldPlane> PlaneOf(const btCollisionObject& body) {
  if (body.getCollisionShape()->getShapeType() != STATIC_PLANE_PROXYTYPE) return std::nullopt;
  const auto& plane = static_cast<const btStaticPlaneShape&>(*body.getCollisionShape());
  const btVector3 normal = body.getWorldTransform().getBasis() * plane.getPlaneNormal();
  return WorldPlane{normal, normal.dot(body.getWorldTransform().getOrigin()) + plane.getPlaneConstant()};
}

inline BoxedBody SeenFromAbove(const btCollisionObject& body, const btDbvtVolume& box) {
  BoxedBody result{box, &body};
  constexpr btScalar kTallest_m = 5;
  if (body.getCollisionShape()->getShapeType() == CAPSULE_SHAPE_PROXYTYPE && Stands(body)) {
    const auto& capsule = static_cast<const btCapsuleShape&>(*body.getCollisionShape());
    const btVector3& middle = body.getWorldTransform().getOrigin();
    const btScalar radius = capsule.getRadius(), half = capsule.getHalfHeight();
    if (half <= kTallest_m) {
      result.x = middle.x();
      result.z = middle.z();
      result.radius = radius;
      const btVector3 reach(radius, half + radius, radius);
      const btVector3 below = middle - reach - box.Mins(), above = box.Maxs() - middle - reach;
      const bool is_boxed = std::min({below.x(), below.y(), below.z(), above.x(), above.y(), above.z()}) >= 0;
      if (is_boxed) {
        result.low = middle.y() - half;
        result.high = middle.y() + half;
      }
      return result;
    }
  }
  const btVector3 center = box.Center(), half = box.Extents();
  result.x = center.x();
  result.z = center.z();
  result.radius = std::sqrt(half.x() * half.x() + half.z() * half.z());
  return result;
}

}  // namespace soarbox::world
