// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <OgreRectangle2D.h>

#include <memory>

#include "viewer/materials.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// A texture that the scene is drawn into when it is drawn smaller than it is shown, and what brings it up: `camera()`
/// sees the texture fill its viewport, softened as little as can be.
class ScaledScene {
 public:
  /// scene: the camera that looks at the scene. samples: per pixel of the texture.
  ScaledScene(Ogre::Root& root, Ogre::Camera& scene, Materials& materials, unsigned samples);
  ~ScaledScene();
  ScaledScene(const ScaledScene&) = delete;
  ScaledScene& operator=(const ScaledScene&) = delete;

  /// Makes the texture anew unless it has this size.
  void SetSize(int width, int height);
  /// Draws the scene into it, unless it is the one that is there already.
  void Draw(bool has_changed);

  Ogre::Camera& camera() { return *camera_; }
  Ogre::RenderTarget* target() const { return target_; }

 private:
  void Drop();

  Ogre::Root& root_;
  Ogre::Camera& scene_;
  Materials& materials_;
  unsigned samples_;
  Ogre::SceneManager* shown_;  ///< Holds nothing but a square with the texture.
  Ogre::Camera* camera_;
  std::unique_ptr<Ogre::Rectangle2D> square_;
  Ogre::MaterialPtr material_;
  Ogre::TexturePtr texture_;
  Ogre::RenderTarget* target_ = nullptr;
  int width_ = 0, height_ = 0;
  bool is_drawn_ = false;
};

}  // namespace soarbox::viewer
