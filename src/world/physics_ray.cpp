// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_ray.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace soarbox::world {
namespace {

// Doubles, because the differences of squares below would lose most of a float's digits at a distance of some hundred
// metres.
struct Vector {
  double x, y, z;
};
double Dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector Along(const Vector& from, const Vector& direction, double share) {
  return {from.x + direction.x * share, from.y + direction.y * share, from.z + direction.z * share};
}

/// A segment in the coordinates of a shape.
struct LocalSegment {
  Vector from, along;
};

LocalSegment Into(const btTransform& place, const btVector3& from, const btVector3& to) {
  const btMatrix3x3& turn = place.getBasis();
  const btVector3 begin = from - place.getOrigin(), along = to - from;
  const auto turned = [&](const btVector3& v) -> Vector {
    return {static_cast<double>(turn.tdotx(v)), static_cast<double>(turn.tdoty(v)), static_cast<double>(turn.tdotz(v))};
  };
  return {turned(begin), turned(along)};
}

RayEntry EntryAt(const btTransform& place, double fraction, const Vector& local_normal) {
  const btVector3 normal(static_cast<btScalar>(local_normal.x), static_cast<btScalar>(local_normal.y),
                         static_cast<btScalar>(local_normal.z));
  return {static_cast<btScalar>(fraction), place.getBasis() * normal};
}

/// The fraction at which a segment from outside enters a circle or sphere around the origin: the smaller root of a * t
/// * t + 2 * b * t + c = 0. Nothing if it is not on the segment.
std::optional<double> FirstRoot(double a, double b, double c) {
  if (b >= 0) return std::nullopt;
  const double inside = b * b - a * c;
  if (inside < 0) return std::nullopt;
  const double share = (-b - std::sqrt(inside)) / a;
  return share <= 1 ? std::optional(std::max(share, 0.0)) : std::nullopt;
}

std::optional<RayEntry> EnterBall(const LocalSegment& segment, const btTransform& place, double radius, double height) {
  const Vector from{segment.from.x, segment.from.y - height, segment.from.z};
  const double outside = Dot(from, from) - radius * radius;
  if (outside < 0) return std::nullopt;
  const auto share = FirstRoot(Dot(segment.along, segment.along), Dot(from, segment.along), outside);
  if (!share) return std::nullopt;
  const Vector point = Along(from, segment.along, *share);
  return EntryAt(place, *share, {point.x / radius, point.y / radius, point.z / radius});
}

std::optional<RayEntry> EnterCapsule(const btCapsuleShape& capsule, const btTransform& place, const btVector3& from,
                                     const btVector3& to) {
  const LocalSegment segment = Into(place, from, to);
  const double radius = static_cast<double>(capsule.getRadius());
  const double half_m = static_cast<double>(capsule.getHalfHeight());
  const double outside = segment.from.x * segment.from.x + segment.from.z * segment.from.z - radius * radius;
  if (outside <= 0) {
    // The start is above, below or between the ends of the axis. Between them, it is inside.
    if (std::abs(segment.from.y) <= half_m) return std::nullopt;
    return EnterBall(segment, place, radius, std::copysign(half_m, segment.from.y));
  }
  const auto share = FirstRoot(segment.along.x * segment.along.x + segment.along.z * segment.along.z,
                               segment.from.x * segment.along.x + segment.from.z * segment.along.z, outside);
  if (!share) return std::nullopt;
  const Vector point = Along(segment.from, segment.along, *share);
  // A segment that crosses the cylinder beyond the end of the axis can only enter through that cap.
  if (std::abs(point.y) > half_m) return EnterBall(segment, place, radius, std::copysign(half_m, point.y));
  return EntryAt(place, *share, {point.x / radius, 0, point.z / radius});
}

std::optional<RayEntry> EnterBox(const btBoxShape& box, const btTransform& place, const btVector3& from,
                                 const btVector3& to) {
  const LocalSegment segment = Into(place, from, to);
  const btVector3 half = box.getHalfExtentsWithMargin();
  const double from_m[] = {segment.from.x, segment.from.y, segment.from.z};
  const double along_m[] = {segment.along.x, segment.along.y, segment.along.z};
  double first = -1, last = 1;
  int side = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = static_cast<double>(half[axis]);
    if (along_m[axis] == 0) {
      if (std::abs(from_m[axis]) > reach) return std::nullopt;
      continue;
    }
    const double towards = along_m[axis] > 0 ? reach : -reach;
    const double enters = (-towards - from_m[axis]) / along_m[axis];
    if (enters > first) {
      first = enters;
      side = axis;
    }
    last = std::min(last, (towards - from_m[axis]) / along_m[axis]);
    if (first > last) return std::nullopt;
  }
  if (first < 0) return std::nullopt;  // It starts inside, or the box is behind it.
  double normal[3] = {};
  normal[side] = along_m[side] > 0 ? -1 : 1;
  return EntryAt(place, first, {normal[0], normal[1], normal[2]});
}

std::optional<RayEntry> EnterPlane(const btStaticPlaneShape& plane, const btTransform& place, const btVector3& from,
                                   const btVector3& to) {
  const btVector3 normal = place.getBasis() * plane.getPlaneNormal();
  const btScalar constant = plane.getPlaneConstant();
  const double begin_m = static_cast<double>(normal.dot(from - place.getOrigin()) - constant);
  const double end_m = static_cast<double>(normal.dot(to - place.getOrigin()) - constant);
  if (begin_m * end_m >= 0) return std::nullopt;
  return RayEntry{static_cast<btScalar>(begin_m / (begin_m - end_m)), begin_m > 0 ? normal : -normal};
}

std::optional<RayEntry> Enter(const btCollisionShape& shape, const btTransform& place, const btVector3& from,
                              const btVector3& to) {
  switch (shape.getShapeType()) {
    case CAPSULE_SHAPE_PROXYTYPE:
      return EnterCapsule(static_cast<const btCapsuleShape&>(shape), place, from, to);
    case BOX_SHAPE_PROXYTYPE:
      return EnterBox(static_cast<const btBoxShape&>(shape), place, from, to);
    case SPHERE_SHAPE_PROXYTYPE:
      return EnterBall(Into(place, from, to), place,
                       static_cast<double>(static_cast<const btSphereShape&>(shape).getRadius()), 0);
    case STATIC_PLANE_PROXYTYPE:
      return EnterPlane(static_cast<const btStaticPlaneShape&>(shape), place, from, to);
    case COMPOUND_SHAPE_PROXYTYPE:
      break;
    default:
      assert(!"physics_shape.cpp makes no such shape");
      return std::nullopt;
  }
  const auto& compound = static_cast<const btCompoundShape&>(shape);
  std::optional<RayEntry> first;
  for (int i = 0; i < compound.getNumChildShapes(); ++i) {
    const auto entry = Enter(*compound.getChildShape(i), place * compound.getChildTransform(i), from, to);
    if (entry && (!first || entry->fraction < first->fraction)) first = entry;
  }
  return first;
}

}  // namespace

std::optional<RayEntry> EntryOf(const btCollisionObject& body, const btVector3& from, const btVector3& to) {
  return Enter(*body.getCollisionShape(), body.getWorldTransform(), from, to);
}

}  // namespace soarbox::world
