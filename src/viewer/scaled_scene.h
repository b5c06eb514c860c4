// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <OgreRectangle2D.h>

#include <memory>

#include "viewer/materials.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// A texture into which the scene is drawn at a smaller scale, and a square that shows it. `camera()` sees the texture
/// fill its viewport, with as little blur as possible.
class ScaledScene {
 public:
  /// `scene` is the camera that looks at the scene. `samples` is the number of samples per pixel of the texture.
  ScaledScene(Ogre::Root& root, Ogre::Camera& scene, Materials& materials, unsigned samples);
  ~ScaledScene();
  ScaledScene(const ScaledScene&) = delete;
  ScaledScene& operator=(const ScaledScene&) = delete;

  /// Creates the texture again if its size differs.
  void SetSize(int width, int height);
  /// Draws the scene into the texture, unless it is already there and has not changed.
  void Draw(bool has_changed);

  Ogre::Camera& camera() { return *camera_; }
  Ogre::RenderTarget* target() const { return target_; }

 private:
  void Drop();

  Ogre::Root& root_;
  Ogre::Camera& scene_;
  Materials& materials_;
  unsigned samples_;
  Ogre::SceneManager* shown_;  ///< Contains only a square with the texture.
  Ogre::Camera* camera_;
  std::unique_ptr<Ogre::Rectangle2D> square_;
  Ogre::MaterialPtr material_;
  Ogre::TexturePtr texture_;
  Ogre::RenderTarget* target_ = nullptr;
  int width_ = 0, height_ = 0;
  bool is_drawn_ = false;
};

}  // namespace soarbox::viewer
