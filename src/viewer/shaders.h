// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>

#include "diagnostics/result.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// How a vertex program learns where things are (media/shaders/place.glsl).
enum class Placing : std::uint8_t {
  kOne,    ///< One thing, by Ogre's own matrix.
  kMany,   ///< Many things in one draw call, by a matrix of each (instance_batch.h).
  kBones,  ///< Many bodies in one draw call, by their bones (bone_rows.h).
};

/// The shader programs of media/shaders, compiled on first use, and the values that all of them share.
///
/// All drawing goes through shaders of our own: what a material looks like stands in four short files and nowhere else.
class Shaders {
 public:
  /// Fails if the folder or one of its files is missing, naming the path.
  /// Low detail leaves out what costs most per pixel.
  static Result<Shaders> Load(const std::filesystem::path& folder, bool low_detail);

  /// The program that also counts lights besides the sun.
  static std::string WithLights(const std::string& fragment);

  /// The vertex program for things that are placed so; "surface.vert" and "shadow.vert" have all three.
  static std::string Placed(const std::string& vertex, Placing placing);

  /// Makes `pass` draw with the two programs ("surface" or "ground" and so on), and binds what Ogre knows: matrices,
  /// camera, viewport, shadow maps. Textures are bound by name in the order of `samplers`.
  void Use(Ogre::Pass& pass, const std::string& vertex, const std::string& fragment,
           const std::vector<std::string>& samplers) const;
  /// Changes the fragment program alone; its values are to be set again.
  void UseFragment(Ogre::Pass& pass, const std::string& fragment, const std::vector<std::string>& samplers) const;

  /// Values that are the same for the whole scene: sun, haze and so on. Set them once per frame.
  Ogre::GpuSharedParameters& scene_values() const { return *scene_values_; }

 private:
  Ogre::GpuSharedParametersPtr scene_values_;
};

}  // namespace soarbox::viewer
