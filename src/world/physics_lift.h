// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/physics_bullet.h"

namespace soarbox::world {

/// Frees upright bodies that were put into fixed ones. If a script puts an agent half into a floor between two blocks,
/// each block pushes it into the other, forever. A body that has been that deep for ten steps is lifted to the
/// first free position above, by at most its height.
class SunkenBodies {
 public:
  /// Call it before the contacts of a step are examined.
  void BeginStep();
  /// Examines a contact of this step. Returns the body that has been too deep for too long, or null.
  btRigidBody* Look(const btPersistentManifold& manifold);
  /// The first free position for the body above its present one; its present position if there is none.
  static btVector3 FreePlaceAbove(btCollisionWorld& world, btRigidBody& body);
  /// Call it before the body is removed.
  void Forget(const btRigidBody& body);

 private:
  struct Sunken {
    const btRigidBody* body;
    int steps;    ///< Number of consecutive steps so far.
    bool is_now;  ///< Also in this step.
  };
  std::vector<Sunken> sunken_;
};

}  // namespace soarbox::world
