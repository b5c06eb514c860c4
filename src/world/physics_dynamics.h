// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/physics_bullet.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Bullet's world, with a shortcut for what most bodies of a crowd do: stand upright, never turn, and move too little
/// in a step to need a sweep. Where such a body is a step later is a sum; Bullet takes its rotation apart and puts it
/// together again three times per step.
class DynamicsWorld final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

 private:
  void predictUnconstraintMotion(btScalar step_s) override;
  void createPredictiveContacts(btScalar step_s) override;
  void integrateTransforms(btScalar step_s) override;

  btAlignedObjectArray<btRigidBody*> others_;  ///< Scratch: bodies that Bullet itself moves.
};

}  // namespace soarbox::world
