// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "viewer/materials.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

struct Ghost;

/// Translucent figures beside the truth: where somebody would be, or is believed to be.
class GhostView {
 public:
  GhostView(Ogre::SceneManager& scene, Materials& materials);

  /// Shows these instead of the ones before.
  void Update(const std::vector<Ghost>& ghosts);

 private:
  struct Figure {
    Ogre::SceneNode* node = nullptr;
    Ogre::Entity* entity = nullptr;
    std::string material;
  };

  Ogre::SceneManager& scene_;
  Materials& materials_;
  Ogre::MeshPtr mesh_;
  std::vector<Figure> figures_;
};

}  // namespace soarbox::viewer
