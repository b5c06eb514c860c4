// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <unordered_map>

#include "viewer/images.h"
#include "viewer/ogre_headers.h"
#include "viewer/palette.h"
#include "viewer/shaders.h"

namespace soarbox::viewer {

/// The texture that holds the bones of all bodies.
inline constexpr const char* kBonesTexture = "Soarbox/Bones";

/// Materials by the names that scripts use, with their textures. All are created here and shared.
class Materials {
 public:
  /// Textures are created at their first use; smaller ones in low detail.
  Materials(const Shaders& shaders, bool low_detail);

  struct Found {
    Ogre::MaterialPtr material;
    bool is_opaque = true;
    bool is_stand_in = false;  ///< The name is unknown; this is the magenta checker.
    world::Color trim;  ///< The colour of the parts without their own paint. Bodies with bones have their own trim.
  };
  const Found& Named(const std::string& name, Placing placing);
  /// From now on surfaces are also lit by lights other than the sun.
  void UseFurtherLights();

  /// The material of an agent's body: the colour of its kind, dull if it failed, grey if it died.
  const Found& AgentBody(std::string_view kind, bool alive, bool failed, Placing placing);

  /// The material of soldiers. The trim is the team's colour on helmet, arms and pack.
  const Found& Soldier();

  /// Size of the sky's faces in pixels. SetSkyPicture replaces the picture of the sky, which surfaces also reflect; it
  /// scales faces of other sizes.
  int sky_face_size() const { return low_detail_ ? 256 : 640; }
  void SetSkyPicture(const std::array<Image, 6>& faces);
  Ogre::MaterialPtr SkyMaterial();

  /// For lines on surfaces, `width_px` wide; visible through everything if `on_top`.
  Ogre::MaterialPtr LineMaterial(float width_px, bool on_top = false);

  /// For translucent triangles, visible from both sides.
  Ogre::MaterialPtr FillMaterial();

  /// Draws ImGui's output with our own shader. Call it once, after the overlay was first shown.
  void AdoptPanelMaterial(const Ogre::MaterialPtr& material);

  /// For a ghost; the colour's alpha is its opacity.
  const Ogre::MaterialPtr& Ghost(world::Color color, Placing placing);

  /// Draws its first texture, which the caller sets, in another size.
  Ogre::MaterialPtr Enlarged();

  /// Draws depth only, for shadow maps.
  Ogre::MaterialPtr ShadowCaster(Placing placing);

 private:
  Found Make(const std::string& name, const Look& look, Placing placing);
  /// Returns the name of the texture, and creates the texture if needed.
  const char* PaintTexture(Look::Paint paint);

  const Shaders& shaders_;
  bool low_detail_;
  bool further_lights_ = false;
  std::unordered_map<std::string, Found> materials_;
};

}  // namespace soarbox::viewer
