// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>

#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// The images that panels of scripts show, as textures: each is read and uploaded once.
class PanelImages {
 public:
  /// Returns the texture of an image's key (world/asset_store.h), for ImGui; 0 if there is no such image.
  Ogre::ResourceHandle Find(const std::string& key);

 private:
  std::map<std::string, Ogre::ResourceHandle> known_;
};

}  // namespace soarbox::viewer
