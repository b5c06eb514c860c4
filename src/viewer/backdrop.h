// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/materials.h"
#include "viewer/ogre_headers.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// Shows the surroundings of a plain (backdrop_meshes.h) while the scene has a plain.
class Backdrop {
 public:
  Backdrop(Ogre::SceneManager& scene, Materials& materials) : scene_(scene), materials_(materials) {}

  void Show(const world::SceneSnapshot& snapshot);

 private:
  void Build();

  Ogre::SceneManager& scene_;
  Materials& materials_;
  Ogre::SceneNode* node_ = nullptr;  ///< Owned by the scene manager; null until it is needed.
};

}  // namespace soarbox::viewer
