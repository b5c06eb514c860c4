// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/physics_bullet.h"
#include "world/workers.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Computes contacts on several threads. Bullet processes the overlapping pairs in order on one thread.
///
/// The order matters only for pairs that may create new contact manifolds. They are processed one by one, in Bullet's
/// order. All other pairs (capsules that have touched before, or that stand on a plane) change only their own manifold
/// and are processed in parallel.
class PairDispatcher final : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;

  /// For the next step.
  void SetWorkers(const Workers* workers) { workers_ = workers; }
  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override;

 private:
  const Workers* workers_ = nullptr;
  std::vector<btBroadphasePair*> known_, others_;  ///< Temporary.
};

}  // namespace soarbox::world
