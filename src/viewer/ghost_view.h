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

/// Translucent figures beside the truth: where somebody would be, or is believed to be.
class GhostView {
 public:
  GhostView(Ogre::SceneManager& scene, Materials& materials);

  ~GhostView();
  GhostView(const GhostView&) = delete;
  GhostView& operator=(const GhostView&) = delete;

  /// Shows these instead of the ones before: with the present bodies of their agents, or as plain figures. Their bones
  /// go into those of the frame.
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
  std::map<std::pair<world::BodyLook, std::string>, std::unique_ptr<InstanceBatch>> batches_;  ///< By material.
};

}  // namespace soarbox::viewer
