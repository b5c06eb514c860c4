// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <unordered_map>

#include "world/physics_bullet.h"

// Limits for many bodies at one place; for the physics_*.cpp files only. Each pair of touching bodies costs time, and n
// bodies at one place have n * n / 2 pairs. Above a number of pairs, further bodies pass through each other. Bodies
// that would touch very many others are set aside, because testing them against bodies that they do not touch also
// costs time.
namespace soarbox::world {

/// Refuses pairs above a limit, and counts the refused pairs of each body.
struct PairLimit final : btOverlapFilterCallback {
  explicit PairLimit(btOverlappingPairCache& given) : pairs(given) {}
  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override;

  btOverlappingPairCache& pairs;
  mutable bool reached = false;  ///< Since the beginning of the world.
};

/// A broadphase that can set bodies aside. Bodies that are set aside collide only with planes, which are infinite. Rays
/// find them at their true positions, because a separate tree contains them.
class CrowdBroadphase final : public btDbvtBroadphase {
 public:
  void setAabb(btBroadphaseProxy* proxy, const btVector3& low, const btVector3& high,
               btDispatcher* dispatcher) override;
  void destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) override;

  /// The trees that rays must search. Together they contain each body at its true position.
  std::array<const btDbvt*, 3> Trees() const { return {&m_sets[0], &m_sets[1], &aside_}; }

 private:
  void LeaveAside(const btBroadphaseProxy* proxy);

  btDbvt aside_;
  std::unordered_map<const btBroadphaseProxy*, btDbvtNode*> aside_leaves_;  ///< Never iterated, because its order is
                                                                            ///< not deterministic.
};

/// Decides which bodies are set aside and returned. The decision depends only on the order of the bodies.
class CrowdControl {
 public:
  CrowdControl(btCollisionWorld& world, PairLimit& limit) : world_(world), limit_(limit) {}

  /// Call it after a body was added or moved to another place. Sets it aside if that place is full.
  void Check(btCollisionObject& body);
  /// Call it before a body leaves the world, permanently or temporarily.
  void Forget(btCollisionObject& body);
  /// Call it after each step.
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
