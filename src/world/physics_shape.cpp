// SPDX-License-Identifier: BSD-2-Clause
#include "world/physics_shape.h"

#include <algorithm>

#include "world/body_values.h"
#include "world/modular_meshes.h"
#include "world/physics_bullet.h"

namespace soarbox::world {
namespace {

float Usable(float size_m) {
  return BodySize("size", size_m).value;
}

void AddBox(PhysicsShape& result, btCompoundShape& compound, Vec3 min, Vec3 max) {
  const Vec3 extent = max - min;
  auto box = std::make_unique<btBoxShape>(btVector3(Usable(extent.x) / 2, Usable(extent.y) / 2, Usable(extent.z) / 2));
  box->setMargin(0.01f);
  compound.addChildShape(btTransform(btQuaternion::getIdentity(), ToBullet((min + max) / 2)), box.get());
  result.children.push_back(std::move(box));
}

PhysicsShape MakeMesh(const MeshBounds& bounds, bool doorway) {
  PhysicsShape result;
  auto compound = std::make_unique<btCompoundShape>();
  if (doorway) {
    for (const ModularMesh& part : AroundDoorway(bounds.min, bounds.max)) AddBox(result, *compound, part.min, part.max);
  } else {
    AddBox(result, *compound, bounds.min, bounds.max);
  }
  result.shape = std::move(compound);
  result.swept_radius_m = Length(bounds.max) / 2;
  result.linear_sleeping_mps = 0.3f;
  return result;
}

}  // namespace

PhysicsShape MakeShape(const BodyDef& def) {
  PhysicsShape result;
  switch (def.shape) {
    case BodyShape::kBox:
      result.shape = std::make_unique<btBoxShape>(
          btVector3(Usable(def.size.x) / 2, Usable(def.size.y) / 2, Usable(def.size.z) / 2));
      result.swept_radius_m = Usable(def.size.x) / 2;
      break;
    case BodyShape::kCapsule: {
      const float radius = Usable(def.size.x);
      result.shape = std::make_unique<btCapsuleShape>(radius, std::max(0.0f, Usable(def.size.y) - 2 * radius));
      result.rolling_friction = 0.2f;
      result.swept_radius_m = radius;
      break;
    }
    case BodyShape::kSphere:
      result.shape = std::make_unique<btSphereShape>(Usable(def.size.x));
      result.rolling_friction = 0.1f;
      result.swept_radius_m = Usable(def.size.x);
      break;
    case BodyShape::kPlane:
      result.shape = std::make_unique<btStaticPlaneShape>(btVector3(0, 1, 0), 0.0f);
      result.rolling_friction = 0.1f;
      break;
    case BodyShape::kMesh:
      return MakeMesh(def.bounds, def.doorway);
  }
  return result;
}

}  // namespace soarbox::world
