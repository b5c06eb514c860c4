// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_sensor.h"

#include <algorithm>

namespace soarbox::world {
namespace {

/// Bounding boxes in the broadphase may be one step old, so the search covers this margin around the sensor.
constexpr btScalar kLag_m = 1;

/// Checks whether any contact point lies inside.
struct OverlapTest final : btCollisionWorld::ContactResultCallback {
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    if (point.getDistance() < 0) overlaps = true;
    return 0;
  }
  bool overlaps = false;
};

}  // namespace

void FindInside(btCollisionWorld& world, const AllBodies& bodies, btCollisionObject& sensor,
                std::vector<EntityId>& found) {
  found.clear();
  btVector3 low, high;
  sensor.getCollisionShape()->getAabb(sensor.getWorldTransform(), low, high);
  const btVector3 lag(kLag_m, kLag_m, kLag_m);
  std::vector<const btCollisionObject*> near;
  VisitTouching(bodies, low - lag, high + lag, [&](const BoxedBody& each) {
    if (!each.body->isStaticObject()) near.push_back(each.body);
  });
  for (const btCollisionObject* body : near) {
    OverlapTest test;
    // Bullet reads both bodies only.
    world.contactPairTest(&sensor, const_cast<btCollisionObject*>(body), test);
    if (test.overlaps) found.push_back(static_cast<EntityId>(body->getUserIndex()));
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

}  // namespace soarbox::world
