// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_debug.h"

#include "world/physics_bullet.h"
#include "world/rotation.h"

namespace soarbox::world {
namespace {

constexpr float kFarthestLine_m = 1e4f;

bool Drawable(Vec3 v) {
  return IsFinite(v) && std::abs(v.x) < kFarthestLine_m && std::abs(v.y) < kFarthestLine_m &&
         std::abs(v.z) < kFarthestLine_m;
}

}  // namespace

void PhysicsLineCollector::drawLine(const btVector3& from, const btVector3& to, const btVector3& color) {
  const Vec3 a = FromBullet(from), b = FromBullet(to);
  if (Drawable(a) && Drawable(b)) lines_.push_back({a, b, {color.x(), color.y(), color.z(), 1}});
}

}  // namespace soarbox::world
