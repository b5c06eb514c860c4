// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "viewer/body_library.h"
#include "viewer/materials.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

struct Ghost;
class SceneView;

/// Translucent figures that show where an agent would be, or is believed to be, next to its true position.
class GhostView {
 public:
  GhostView(Ogre::SceneManager& scene, Materials& materials);

  ~GhostView();
  GhostView(const GhostView&) = delete;
  GhostView& operator=(const GhostView&) = delete;

  /// Replaces the ghosts of the last frame. A ghost has the current body of its agent, or a plain figure. The bones are
  /// added to `bones`.
  void Update(const std::vector<Ghost>& ghosts, const SceneView& bodies, BoneTexture& bones);

 private:
  struct Figure {
    Ogre::SceneNode* node = nullptr;
    Ogre::Entity* entity = nullptr;
    std::string material;
  };

  Figure MakeFigure();

  Ogre::SceneManager& scene_;
  Materials& materials_;
  Ogre::MeshPtr mesh_;
  std::vector<Figure> figures_;
  BodyLibrary library_;
  std::map<std::pair<world::BodyLook, std::string>, std::unique_ptr<InstanceBatch>>
      batches_;  ///< By look and material.
};

}  // namespace soarbox::viewer
