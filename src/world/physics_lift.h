// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "world/physics_bullet.h"

namespace soarbox::world {

/// Gets upright bodies out of fixed ones that they were put into. Where a script puts an agent half into a floor
/// between two blocks, each block pushes it into the other, for ever. A body that has been that deep for a third of a
/// second is lifted to the first free place above, no farther than it is tall.
class SunkenBodies {
 public:
  /// Before the contacts of a step are looked at.
  void BeginStep();
  /// A contact of this step. Returns the body that has been too deep for too long, or null.
  btRigidBody* Look(const btPersistentManifold& manifold);
  /// The first place above where its origin has room; its present place if there is none.
  static btVector3 FreePlaceAbove(btCollisionWorld& world, btRigidBody& body);
  /// The body is about to go.
  void Forget(const btRigidBody& body);

 private:
  struct Sunken {
    const btRigidBody* body;
    int steps;    ///< How many in a row, so far.
    bool is_now;  ///< In this step too.
  };
  std::vector<Sunken> sunken_;
};

}  // namespace soarbox::world
