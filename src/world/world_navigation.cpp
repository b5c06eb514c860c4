// SPDX-License-Identifier: BSD-2-Clause
#include "world/modular_meshes.h"
#include "world/scene_node.h"
#include "world/world.h"
#include "world/world_impl.h"

// Navigation meshes and influence maps of a world.
namespace soarbox::world {

NavigationGeometry World::Impl::FixedGeometry() const {
  NavigationGeometry geometry;
  for (const auto& [id, object] : objects) {
    if (object->Mass() > 0 || object->removal_requested_) continue;
    const Scene::Node* looks = scene.Find(object->node_);
    if (!looks) continue;
    const Vec3 position = object->Position();
    const Quat turn = object->Orientation();
    switch (object->kind_) {
      case ObjectKind::kBox:
      case ObjectKind::kMesh: {  // Their bodies are boxes, too.
        const auto add = [&](Vec3 min, Vec3 max) { geometry.AddBox((min + max) / 2, (max - min) / 2, position, turn); };
        if (!HasDoorway(looks->drawable.mesh.value())) {
          add(looks->bounds.min, looks->bounds.max);
          break;
        }
        for (const ModularMesh& part : AroundDoorway(looks->bounds.min, looks->bounds.max)) add(part.min, part.max);
        break;
      }
      case ObjectKind::kCapsule:
        geometry.AddCapsule(looks->drawable.size.x, looks->drawable.size.y, position, turn);
        break;
      case ObjectKind::kPlane:
      case ObjectKind::kPhysicsCapsule:
      case ObjectKind::kPhysicsSphere:
      case ObjectKind::kSensor:
        break;
    }
  }
  return geometry;
}

Result<bool> World::CreateNavigationMesh(std::string_view name, const NavigationConfig& config) {
  return impl_->navigation.Create(name, impl_->FixedGeometry(), config);
}

double World::NavigationCells(const NavigationConfig& config) const {
  return NavigationMesh::CoveredCells(impl_->FixedGeometry(), config);
}

Navigation& World::navigation() {
  return impl_->navigation;
}

Result<void> World::CreateInfluenceMap(std::string_view navigation_mesh, const InfluenceConfig& config) {
  const Result<const NavigationMesh*> mesh = impl_->navigation.Find(navigation_mesh);
  if (!mesh.ok()) return mesh.error();
  Result<InfluenceMap> map = InfluenceMap::Create(*mesh.value(), config);
  if (!map.ok()) return map.error();
  impl_->influence = std::move(map.value());
  return {};
}

InfluenceMap* World::influence() {
  return impl_->influence ? &*impl_->influence : nullptr;
}

}  // namespace soarbox::world
