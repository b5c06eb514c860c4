// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "viewer/materials.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// The sky box around the camera. The pictures of a sky are computed when it is shown.
class SkyView {
 public:
  SkyView(Ogre::SceneManager& scene, Materials& materials);

  /// Shows the sky with this name, or a plain one for an empty name. Returns false if the name is unknown (a default is
  /// shown).
  bool Show(const std::string& name);

  void Follow(const Ogre::Vector3& camera_position) { node_->setPosition(camera_position); }

 private:
  Materials& materials_;
  Ogre::SceneNode* node_;
  std::string shown_ = "?";
  bool known_ = true;
};

}  // namespace soarbox::viewer
