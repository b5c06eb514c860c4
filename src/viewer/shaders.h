// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>

#include "diagnostics/result.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// How a vertex program gets the places of things (media/shaders/place.glsl).
enum class Placing : std::uint8_t {
  kOne,    ///< One thing, placed by Ogre's own matrix.
  kMany,   ///< Many things in one draw call, each with its matrix (instance_batch.h).
  kBones,  ///< Many bodies in one draw call, placed by their bones (BoneTexture, body_library.h).
};

/// The shader programs in media/shaders, compiled on first use, and the values that they share.
///
/// All drawing uses our own shaders, so the look of materials is defined only in these files.
class Shaders {
 public:
  /// Returns an error with the path if the folder or one of its files is missing. `low_detail` leaves out the features
  /// with the highest cost per pixel.
  static Result<Shaders> Load(const std::filesystem::path& folder, bool low_detail);

  /// The program that also uses lights other than the sun.
  static std::string WithLights(const std::string& fragment);

  /// The vertex program for this placing; "surface.vert" and "shadow.vert" have all three.
  static std::string Placed(const std::string& vertex, Placing placing);

  /// Makes `pass` draw with the two programs ("surface.vert", "ground.frag" and so on), and binds Ogre's values:
  /// matrices, camera, viewport, shadow maps. Textures are bound by name in the order of `samplers`.
  void Use(Ogre::Pass& pass, const std::string& vertex, const std::string& fragment,
           const std::vector<std::string>& samplers) const;
  /// Changes only the fragment program. Set its values again.
  void UseFragment(Ogre::Pass& pass, const std::string& fragment, const std::vector<std::string>& samplers) const;

  /// Values of the entire scene: sun, haze and so on. Set them once per frame.
  Ogre::GpuSharedParameters& scene_values() const { return *scene_values_; }

 private:
  Ogre::GpuSharedParametersPtr scene_values_;
};

}  // namespace soarbox::viewer
