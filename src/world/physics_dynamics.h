// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "world/physics_bullet.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// Bullet's world with a fast path for most bodies of a crowd: those that stay upright, do not rotate, and move too
/// little in a step to need continuous collision detection. Their next position is a simple sum. Bullet would decompose
/// and recompose their rotation three times per step.
class DynamicsWorld final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

 private:
  void predictUnconstraintMotion(btScalar step_s) override;
  void createPredictiveContacts(btScalar step_s) override;
  void integrateTransforms(btScalar step_s) override;

  btAlignedObjectArray<btRigidBody*> others_;  ///< Temporary: bodies that Bullet moves itself.
};

}  // namespace soarbox::world
