// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <memory>

#include "viewer/body_mesh.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// The meshes of bodies with a skeleton: what all bodies of one look and detail share, made once.
class BodyLibrary {
 public:
  struct Shared {
    SkinMesh skin;
    const world::Skeleton* skeleton = nullptr;
    Ogre::HardwareVertexBufferSharedPtr paint;  ///< Places on the picture of cloths, tint, light and gloss.
    Ogre::HardwareIndexBufferSharedPtr indices;
  };
  const Shared& For(world::BodyLook look, BodyDetail detail);

 private:
  std::map<std::pair<world::BodyLook, BodyDetail>, Shared> shared_;
};

/// One body: a mesh of its own, whose vertices follow its bones.
class SkinnedBody {
 public:
  SkinnedBody(const BodyLibrary::Shared& shared, const std::string& name);
  ~SkinnedBody();
  SkinnedBody(const SkinnedBody&) = delete;
  SkinnedBody& operator=(const SkinnedBody&) = delete;

  const Ogre::MeshPtr& mesh() const { return mesh_; }
  /// Once per frame; does nothing if the bones are where they were.
  void Move(const std::vector<world::BonePose>& bones);

 private:
  const BodyLibrary::Shared& shared_;
  Ogre::MeshPtr mesh_;
  Ogre::HardwareVertexBufferSharedPtr places_;
  std::vector<world::BonePose> shown_;
};

}  // namespace soarbox::viewer
