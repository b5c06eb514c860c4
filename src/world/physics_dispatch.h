// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/physics_bullet.h"
#include "world/workers.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Finds contacts on all threads. Bullet goes through the pairs of boxes that overlap, sorted, on one.
///
/// The order matters only for pairs that make new contact lists or may do so: these come in Bullet's order, one by one.
/// All others, those of capsules that have met before or stand on a plane, change nothing but their own list.
class PairDispatcher final : public btCollisionDispatcher {
 public:
  using btCollisionDispatcher::btCollisionDispatcher;

  /// For the next step.
  void SetWorkers(const Workers* workers) { workers_ = workers; }
  void dispatchAllCollisionPairs(btOverlappingPairCache* pairs, const btDispatcherInfo& info,
                                 btDispatcher* dispatcher) override;

 private:
  const Workers* workers_ = nullptr;
  std::vector<btBroadphasePair*> known_, others_;  ///< Scratch.
};

}  // namespace soarbox::world
