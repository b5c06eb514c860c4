// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <btBulletDynamicsCommon.h>

#include "world/math.h"

// For the physics_*.cpp files only.
namespace soarbox::world {

inline btVector3 ToBullet(Vec3 v) {
  return {v.x, v.y, v.z};
}
inline btQuaternion ToBullet(Quat q) {
  return {q.x, q.y, q.z, q.w};
}
inline Vec3 FromBullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
inline Quat FromBullet(const btQuaternion& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace soarbox::world
