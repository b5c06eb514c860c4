// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_capsule_plane.h"

#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>

namespace soarbox::world {
namespace {

class CapsulePlaneAlgorithm final : public btCollisionAlgorithm {
 public:
  CapsulePlaneAlgorithm(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* capsule,
                        const btCollisionObjectWrapper* plane, bool plane_is_first)
      : btCollisionAlgorithm(info), plane_is_first_(plane_is_first) {
    const btCollisionObject* a = capsule->getCollisionObject();
    const btCollisionObject* b = plane->getCollisionObject();
    if (m_dispatcher->needsCollision(a, b)) manifold_ = m_dispatcher->getNewManifold(a, b);
  }
  ~CapsulePlaneAlgorithm() override {
    if (manifold_ != nullptr) m_dispatcher->releaseManifold(manifold_);
  }
  CapsulePlaneAlgorithm(const CapsulePlaneAlgorithm&) = delete;
  CapsulePlaneAlgorithm& operator=(const CapsulePlaneAlgorithm&) = delete;

  void processCollision(const btCollisionObjectWrapper* first, const btCollisionObjectWrapper* second,
                        const btDispatcherInfo&, btManifoldResult* result) override {
    if (manifold_ == nullptr) return;
    const btCollisionObjectWrapper& capsule = plane_is_first_ ? *second : *first;
    const btCollisionObjectWrapper& plane = plane_is_first_ ? *first : *second;
    const auto& shape = *static_cast<const btCapsuleShape*>(capsule.getCollisionShape());
    const auto& ground = *static_cast<const btStaticPlaneShape*>(plane.getCollisionShape());

    const btVector3 up = plane.getWorldTransform().getBasis() * ground.getPlaneNormal();
    const btTransform& place = capsule.getWorldTransform();
    btVector3 axis = place.getBasis().getColumn(shape.getUpAxis()) * shape.getHalfHeight();
    if (axis.dot(up) > 0) axis = -axis;
    const btVector3 lowest = place.getOrigin() + axis - up * shape.getRadius();
    const btScalar height = up.dot(lowest - plane.getWorldTransform().getOrigin()) - ground.getPlaneConstant();

    result->setPersistentManifold(manifold_);
    if (height < manifold_->getContactBreakingThreshold()) result->addContactPoint(up, lowest - up * height, height);
    if (manifold_->getNumContacts() > 0) result->refreshContactPoints();
  }
  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;  // Not used: DynamicsWorld sweeps fast bodies itself.
  }
  void getAllContactManifolds(btManifoldArray& manifolds) override {
    if (manifold_ != nullptr) manifolds.push_back(manifold_);
  }

 private:
  btPersistentManifold* manifold_ = nullptr;
  bool plane_is_first_;
};

/// m_swapped: the plane is the first body.
struct CapsulePlaneMaker final : btCollisionAlgorithmCreateFunc {
  explicit CapsulePlaneMaker(bool plane_is_first) { m_swapped = plane_is_first; }
  btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                 const btCollisionObjectWrapper* first,
                                                 const btCollisionObjectWrapper* second) override {
    void* place = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(CapsulePlaneAlgorithm));
    return new (place) CapsulePlaneAlgorithm(info, m_swapped ? second : first, m_swapped ? first : second, m_swapped);
  }
};

}  // namespace

void FindCapsulesOnPlanes(btCollisionDispatcher& dispatcher) {
  // Stateless; the dispatchers of all worlds share them.
  static CapsulePlaneMaker capsule_first(false), plane_first(true);
  dispatcher.registerCollisionCreateFunc(CAPSULE_SHAPE_PROXYTYPE, STATIC_PLANE_PROXYTYPE, &capsule_first);
  dispatcher.registerCollisionCreateFunc(STATIC_PLANE_PROXYTYPE, CAPSULE_SHAPE_PROXYTYPE, &plane_first);
}

}  // namespace soarbox::world
