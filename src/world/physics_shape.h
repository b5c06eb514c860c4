// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "world/physics_world.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

/// A collision shape and the data that belong to it.
struct PhysicsShape {
  std::vector<std::unique_ptr<btCollisionShape>> children;  ///< Children of a compound shape; must outlive it.
  std::unique_ptr<btCollisionShape> shape;
  float rolling_friction = 0;
  float swept_radius_m = 0;  ///< For continuous collision detection; 0: none.
  float linear_sleeping_mps = 0.8f;
};

/// Creates the shape of a body. Sizes are clamped to the limits of PhysicsWorld.
PhysicsShape MakeShape(const BodyDef& def);

}  // namespace soarbox::world
