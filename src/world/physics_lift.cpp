// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_lift.h"

#include <algorithm>

namespace soarbox::world {
namespace {

constexpr btScalar kDeep_m = 0.1f;
constexpr int kPatience_steps = 10;
constexpr btScalar kLift_m = 0.05f;
/// A contact of this depth does not prevent a body from standing there.
constexpr btScalar kTouch_m = 0.01f;

bool IsUpright(const btRigidBody* body) {
  return body != nullptr && !body->isStaticObject() && body->getAngularFactor().isZero();
}

btScalar DeepestDistance(const btPersistentManifold& manifold) {
  btScalar deepest = 0;
  for (int i = 0; i < manifold.getNumContacts(); ++i)
    deepest = std::min(deepest, manifold.getContactPoint(i).getDistance());
  return deepest;
}

/// Whether a body at this position would be inside a fixed one.
struct Obstruction final : btCollisionWorld::ContactResultCallback {
  Obstruction() { m_collisionFilterMask = btBroadphaseProxy::StaticFilter; }
  btScalar addSingleResult(btManifoldPoint& contact, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    found = found || contact.getDistance() < -kTouch_m;
    return 0;
  }
  bool found = false;
};

}  // namespace

void SunkenBodies::BeginStep() {
  std::erase_if(sunken_, [](const Sunken& entry) { return !entry.is_now; });
  for (Sunken& entry : sunken_) entry.is_now = false;
}

void SunkenBodies::Forget(const btRigidBody& body) {
  std::erase_if(sunken_, [&](const Sunken& entry) { return entry.body == &body; });
}

btRigidBody* SunkenBodies::Look(const btPersistentManifold& manifold) {
  // Few contacts are that deep.
  if (DeepestDistance(manifold) > -kDeep_m) return nullptr;
  auto* body = const_cast<btRigidBody*>(btRigidBody::upcast(manifold.getBody0()));
  const btCollisionObject* other = manifold.getBody1();
  if (!IsUpright(body)) {
    body = const_cast<btRigidBody*>(btRigidBody::upcast(manifold.getBody1()));
    other = manifold.getBody0();
  }
  if (!IsUpright(body) || !other->isStaticObject()) return nullptr;
  auto known = std::find_if(sunken_.begin(), sunken_.end(), [&](const Sunken& entry) { return entry.body == body; });
  if (known == sunken_.end()) known = sunken_.insert(known, {body, 0, false});
  if (known->is_now) return nullptr;
  known->is_now = true;
  if (++known->steps < kPatience_steps) return nullptr;
  known->steps = 0;
  return body;
}

btVector3 SunkenBodies::FreePlaceAbove(btCollisionWorld& world, btRigidBody& body) {
  btVector3 low, high;
  body.getAabb(low, high);
  const btScalar height = high.y() - low.y();
  btCollisionObject probe;
  probe.setCollisionShape(body.getCollisionShape());
  btTransform place = body.getWorldTransform();
  const btVector3 origin = place.getOrigin();
  for (int i = 1; static_cast<btScalar>(i) * kLift_m <= height; ++i) {
    place.setOrigin(origin + btVector3(0, static_cast<btScalar>(i) * kLift_m, 0));
    probe.setWorldTransform(place);
    Obstruction obstruction;
    world.contactTest(&probe, obstruction);
    if (!obstruction.found) return place.getOrigin();
  }
  return origin;
}

}  // namespace soarbox::world
