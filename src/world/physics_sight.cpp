// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_sight.h"

#include <algorithm>

namespace soarbox::world {
namespace {

constexpr btScalar kSlack_m = 0.02f;

/// The square of the distance on the ground between a point and a segment.
btScalar GroundDistanceSquared(const btVector3& point, const btVector3& from, const btVector3& to) {
  const btScalar along_x = to.x() - from.x(), along_z = to.z() - from.z();
  const btScalar offset_x = point.x() - from.x(), offset_z = point.z() - from.z();
  const btScalar squared = along_x * along_x + along_z * along_z;
  const btScalar share = squared > 0
                             ? std::clamp((offset_x * along_x + offset_z * along_z) / squared, btScalar(0), btScalar(1))
                             : btScalar(0);
  const btScalar x = offset_x - share * along_x, z = offset_z - share * along_z;
  return x * x + z * z;
}

bool MayHitCapsule(const btCollisionObject& object, const btVector3& from, const btVector3& to) {
  const btTransform& place = object.getWorldTransform();
  const btMatrix3x3& turn = place.getBasis();
  const bool is_upright = std::abs(turn[0][1]) < 1e-4f && std::abs(turn[2][1]) < 1e-4f;
  if (!is_upright) return true;
  const btScalar reach = static_cast<const btCapsuleShape*>(object.getCollisionShape())->getRadius() + kSlack_m;
  return GroundDistanceSquared(place.getOrigin(), from, to) <= reach * reach;
}

bool MayHitPlane(const btCollisionObject& object, const btVector3& from, const btVector3& to) {
  const auto& plane = *static_cast<const btStaticPlaneShape*>(object.getCollisionShape());
  const btTransform into = object.getWorldTransform().inverse();
  const auto height = [&](const btVector3& point) {
    return plane.getPlaneNormal().dot(into * point) - plane.getPlaneConstant();
  };
  return height(from) <= kSlack_m || height(to) <= kSlack_m;
}

/// Ends at the first body that hides the target.
class BlockerQuery final : public btCollisionWorld::RayResultCallback {
 public:
  BlockerQuery(const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
               const btCollisionObject* target)
      : from_(from), to_(to), viewer_(viewer), target_(target) {
    m_collisionFilterGroup = m_collisionFilterMask = btBroadphaseProxy::AllFilter;
  }

  bool needsCollision(btBroadphaseProxy* proxy) const override {
    const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
    return object != viewer_ && object != target_ && MayHit(*object, from_, to_);
  }
  btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool) override {
    m_collisionObject = result.m_collisionObject;
    m_closestHitFraction = 0;  // Nothing can come nearer: the search is over.
    return 0;
  }

 private:
  btVector3 from_, to_;
  const btCollisionObject* viewer_;
  const btCollisionObject* target_;
};

}  // namespace

bool MayHit(const btCollisionObject& object, const btVector3& from, const btVector3& to) {
  switch (object.getCollisionShape()->getShapeType()) {
    case CAPSULE_SHAPE_PROXYTYPE:
      return MayHitCapsule(object, from, to);
    case STATIC_PLANE_PROXYTYPE:
      return MayHitPlane(object, from, to);
    default:
      return true;
  }
}

FirstHit::FirstHit(const btVector3& from, const btVector3& to) : ClosestRayResultCallback(from, to) {
  m_collisionFilterGroup = m_collisionFilterMask = btBroadphaseProxy::AllFilter;
}

bool FirstHit::needsCollision(btBroadphaseProxy* proxy) const {
  return MayHit(*static_cast<const btCollisionObject*>(proxy->m_clientObject), m_rayFromWorld, m_rayToWorld);
}

bool IsClear(const btCollisionWorld& world, const btVector3& from, const btVector3& to, const btCollisionObject* viewer,
             const btCollisionObject* target) {
  BlockerQuery query(from, to, viewer, target);
  if (target) {
    // What stands behind the target's surface, or leans into it, hides nothing.
    btCollisionWorld::ClosestRayResultCallback surface(from, to);
    const btTransform begin(btQuaternion::getIdentity(), from), end(btQuaternion::getIdentity(), to);
    auto* object = const_cast<btCollisionObject*>(target);
    btCollisionWorld::rayTestSingle(begin, end, object, object->getCollisionShape(), object->getWorldTransform(),
                                    surface);
    query.m_closestHitFraction = surface.m_closestHitFraction;
  }
  world.rayTest(from, to, query);
  return !query.hasHit();
}

}  // namespace soarbox::world
