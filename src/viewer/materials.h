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

/// Materials by the names that scripts use, and the textures behind them, all made here and shared.
class Materials {
 public:
  /// Pictures are made when something first wears them; in low detail smaller ones.
  Materials(const Shaders& shaders, bool low_detail);

  struct Found {
    Ogre::MaterialPtr material;
    bool is_opaque = true;
    bool is_stand_in = false;  ///< The name is unknown; this is the magenta checker.
    world::Color trim;         ///< Where the paint has no colour of its own; bodies with bones bring theirs along.
  };
  const Found& Named(const std::string& name, Placing placing);
  /// From now on surfaces are lit by further lights than the sun.
  void UseFurtherLights();

  /// The body of an agent: its kind's colour, dull if it failed, grey if it died.
  const Found& AgentBody(std::string_view kind, bool alive, bool failed, Placing placing);

  /// What soldiers wear; the trim of each body is its team's colour, on helmet, arms and pack.
  const Found& Soldier();

  /// Replaces the picture of the sky, which surfaces mirror too. Faces of other sizes are scaled.
  int sky_face_size() const { return low_detail_ ? 256 : 640; }
  void SetSkyPicture(const std::array<Image, 6>& faces);
  Ogre::MaterialPtr SkyMaterial();

  /// Lines that lie on top of surfaces, `width_px` wide; seen through everything if `on_top`.
  Ogre::MaterialPtr LineMaterial(float width_px, bool on_top = false);

  /// Translucent triangles, seen from both sides.
  Ogre::MaterialPtr FillMaterial();

  /// Draws what ImGui produced with our own shader; call once, after the overlay was first shown.
  void AdoptPanelMaterial(const Ogre::MaterialPtr& material);

  /// A ghost; the colour's alpha says how much it shows.
  const Ogre::MaterialPtr& Ghost(world::Color color, Placing placing);

  /// Shows its first texture, to be set by whoever uses it, in another size.
  Ogre::MaterialPtr Enlarged();

  /// Renders depth only, for shadow maps.
  Ogre::MaterialPtr ShadowCaster(Placing placing);

 private:
  Found Make(const std::string& name, const Look& look, Placing placing);
  /// The name of the texture, which is there now.
  const char* PaintTexture(Look::Paint paint);

  const Shaders& shaders_;
  bool low_detail_;
  bool further_lights_ = false;
  std::unordered_map<std::string, Found> materials_;
};

}  // namespace soarbox::viewer
