// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <unordered_map>

#include "world/physics_bullet.h"

// Many bodies at one place, for the physics_*.cpp files only. Two things that touch cost time, and a heap of n things
// has n * n / 2 such pairs. So there are limits: beyond a number of pairs, further bodies pass through each other; and
// bodies that would touch very many others are put aside, because finding what they do not touch costs time as well.
namespace soarbox::world {

/// Refuses pairs beyond a number, and counts how many each body was refused.
struct PairLimit final : btOverlapFilterCallback {
  explicit PairLimit(btOverlappingPairCache& given) : pairs(given) {}
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;

  btOverlappingPairCache& pairs;
  mutable bool reached = false;  ///< Since the world began.
};

/// The broad phase with a place aside, where bodies meet nothing but planes: those reach everywhere. Rays find bodies
/// that are aside where they really are: a separate tree knows.
class CrowdBroadphase final : public btDbvtBroadphase {
 public:
  void setAabb(btBroadphaseProxy* proxy, const btVector3& low, const btVector3& high,
               btDispatcher* dispatcher) override;
  void destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) override;

  /// The trees in which rays look for bodies: all of them together hold each body where it is.
  std::array<const btDbvt*, 3> Trees() const { return {&m_sets[0], &m_sets[1], &aside_}; }

 private:
  void LeaveAside(const btBroadphaseProxy* proxy);

  btDbvt aside_;
  std::unordered_map<const btBroadphaseProxy*, btDbvtNode*> aside_leaves_;  ///< Never iterated in its own order.
};

/// Puts bodies aside and lets them back. Which ones depends on the order of the bodies alone.
class CrowdControl {
 public:
  CrowdControl(btCollisionWorld& world, PairLimit& limit) : world_(world), limit_(limit) {}

  /// A body was added, or moved to another place: puts it aside if that place is full.
  void Check(btCollisionObject& body);
  /// A body is about to leave the world, for good or for a moment.
  void Forget(btCollisionObject& body);
  /// After a step.
  void CheckAll();
  static bool IsAside(const btCollisionObject& body);

 private:
  void Put(btCollisionObject& body, bool aside);

  btCollisionWorld& world_;
  PairLimit& limit_;
  int aside_ = 0;
  int next_back_ = 0;
};

}  // namespace soarbox::world
