// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/backdrop.h"

#include <algorithm>
#include <string>

#include "viewer/backdrop_meshes.h"
#include "viewer/drawable_mesh.h"
#include "viewer/mesh_library.h"

namespace soarbox::viewer {

void Backdrop::Build() {
  node_ = scene_.getRootSceneNode()->createChildSceneNode();
  const auto add = [&](const char* name, const MeshData& data) {
    Ogre::Entity* entity = scene_.createEntity(UploadMesh(std::string("Soarbox/Backdrop/") + name, data));
    entity->setMaterial(materials_.Named(data.material, Placing::kOne).material);
    entity->setCastShadows(false);
    node_->attachObject(entity);
  };
  add("hills", HillsMesh());
  add("trees", TreesMesh());
  add("fence", FenceMesh());
}

void Backdrop::Show(const world::SceneSnapshot& snapshot) {
  const bool has_plain = std::any_of(snapshot.drawables.begin(), snapshot.drawables.end(), IsPlain);
  if (has_plain && node_ == nullptr) Build();
  if (node_ != nullptr) node_->setVisible(has_plain);
}

}  // namespace soarbox::viewer
