// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_crowd.h"

namespace soarbox::world {
namespace {

constexpr int kMostPairs = 60'000;
/// A body with more refused pairs than this is set aside.
constexpr int kMostRefused = 500;
/// Number of bodies that are returned after each step, to find out whether they have left the crowd.
constexpr int kBackPerStep = 20;

// Marks on Bullet's objects: the second index is 1 for those that are set aside, the third is the number of refusals.
constexpr int kAside = 1, kPresent = -1;

btCollisionObject& ObjectOf(const btBroadphaseProxy& proxy) {
  return *static_cast<btCollisionObject*>(proxy.m_clientObject);
}

/// The bounding boxes of walking bodies are extended forward by this number of half widths, so that they stay valid for
/// some steps. Those of rolling or resting things, and of bodies that were moved by a script, are not: they would
/// continue to overlap bodies that they do not touch.
btScalar BoxAhead(const btBroadphaseProxy& proxy, const btVector3& low) {
  constexpr btScalar kWalker = 2, kFarthestStep_m = 0.5f;
  const btRigidBody* body = btRigidBody::upcast(&ObjectOf(proxy));
  const bool walks = body != nullptr && body->getAngularFactor().isZero() && !body->isStaticObject();
  return walks && (low - proxy.m_aabbMin).length2() < kFarthestStep_m * kFarthestStep_m ? kWalker : 0;
}

}  // namespace

bool PairLimit::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
  const bool wanted = (a->m_collisionFilterGroup & b->m_collisionFilterMask) != 0 &&
                      (b->m_collisionFilterGroup & a->m_collisionFilterMask) != 0;
  if (!wanted || pairs.getNumOverlappingPairs() < kMostPairs) return wanted;
  // Fixed bodies support the others, so their pairs have a higher limit.
  const bool is_fixed = ObjectOf(*a).isStaticObject() || ObjectOf(*b).isStaticObject();
  if (is_fixed && pairs.getNumOverlappingPairs() < 3 * kMostPairs) return true;
  reached = true;
  for (const btBroadphaseProxy* proxy : {a, b}) ObjectOf(*proxy).setUserIndex3(ObjectOf(*proxy).getUserIndex3() + 1);
  return false;
}

void CrowdBroadphase::setAabb(btBroadphaseProxy* proxy, const btVector3& low, const btVector3& high,
                              btDispatcher* dispatcher) {
  if (!CrowdControl::IsAside(ObjectOf(*proxy))) {
    LeaveAside(proxy);
    m_prediction = BoxAhead(*proxy, low);
    return btDbvtBroadphase::setAabb(proxy, low, high, dispatcher);
  }
  btDbvtVolume where = btDbvtVolume::FromMM(low, high);
  const auto [leaf, is_new] = aside_leaves_.try_emplace(proxy);
  if (is_new) {
    leaf->second = aside_.insert(where, proxy);
  } else {
    aside_.update(leaf->second, where);
  }
  // Far away, each at a separate point.
  constexpr btScalar kBegin_m = 2e6f, kApart_m = 16;
  const btVector3 point(kBegin_m + kApart_m * static_cast<btScalar>(proxy->m_uniqueId), 0, 0);
  btDbvtBroadphase::setAabb(proxy, point, point, dispatcher);
}

void CrowdBroadphase::destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) {
  LeaveAside(proxy);
  btDbvtBroadphase::destroyProxy(proxy, dispatcher);
}

void CrowdBroadphase::LeaveAside(const btBroadphaseProxy* proxy) {
  if (aside_leaves_.empty()) return;
  const auto leaf = aside_leaves_.find(proxy);
  if (leaf == aside_leaves_.end()) return;
  aside_.remove(leaf->second);
  aside_leaves_.erase(leaf);
}

bool CrowdControl::IsAside(const btCollisionObject& body) {
  return body.getUserIndex2() == kAside;
}

void CrowdControl::Put(btCollisionObject& body, bool aside) {
  body.setUserIndex2(aside ? kAside : kPresent);
  body.setUserIndex3(0);
  aside_ += aside ? 1 : -1;
  if (aside) {
    world_.getBroadphase()->getOverlappingPairCache()->cleanProxyFromPairs(body.getBroadphaseHandle(),
                                                                           world_.getDispatcher());
  }
  world_.updateSingleAabb(&body);
}

void CrowdControl::Check(btCollisionObject& body) {
  if (!limit_.reached || body.isStaticObject()) return;
  if (IsAside(body)) Put(body, false);
  if (body.getUserIndex3() > kMostRefused) Put(body, true);
  body.setUserIndex3(0);
}

void CrowdControl::Forget(btCollisionObject& body) {
  if (IsAside(body)) --aside_;
  body.setUserIndex2(kPresent);
  body.setUserIndex3(0);
}

void CrowdControl::CheckAll() {
  if (!limit_.reached) return;
  const btCollisionObjectArray& bodies = world_.getCollisionObjectArray();
  // Sets the last bodies aside first. Each one that is set aside reduces the refusals of the others.
  int gone = 0;
  for (int i = bodies.size() - 1; i >= 0; --i) {
    if (!IsAside(*bodies[i]) && bodies[i]->getUserIndex3() - gone > kMostRefused) {
      Put(*bodies[i], true);
      ++gone;
    }
  }
  for (int i = 0; i < bodies.size(); ++i) bodies[i]->setUserIndex3(0);
  if (gone > 0) return;
  for (int looked_at = 0, back = 0; looked_at < bodies.size() && back < kBackPerStep && aside_ > 0; ++looked_at) {
    next_back_ = (next_back_ + 1) % bodies.size();
    btCollisionObject& body = *bodies[next_back_];
    if (!IsAside(body)) continue;
    Put(body, false);
    ++back;
    Check(body);
  }
}

}  // namespace soarbox::world
