// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>

#include "viewer/ogre_headers.h"
#include "viewer/shaders.h"

namespace soarbox::viewer {

/// Sun, ambient light, further lights and shadow maps.
///
/// The first directional light of a snapshot is the sun. Only the sun casts shadows, with two shadow maps: a fine one
/// for the area in front of the camera and a coarse one around it. Up to four further lights shine without shadows.
class LightRig {
 public:
  LightRig(Ogre::SceneManager& scene, const Shaders& shaders, const Ogre::MaterialPtr& caster, bool low_detail);

  /// Returns whether there are further lights.
  bool Update(const world::SceneSnapshot& snapshot);

  /// Rotates the sky's picture relative to the world.
  void SetSkyRotation(world::Vec3 degrees);

 private:
  Ogre::GpuSharedParameters& values_;
  Ogre::SceneNode* sun_node_;
  Ogre::Light* sun_;
};

}  // namespace soarbox::viewer
