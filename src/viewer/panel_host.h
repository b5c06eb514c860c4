// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <set>
#include <string>

#include "viewer/materials.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// Owns ImGui's overlay, its fonts and its input. Only one exists at a time, as ImGui has one context.
class PanelHost {
 public:
  explicit PanelHost(Materials& materials);
  ~PanelHost();
  PanelHost(const PanelHost&) = delete;
  PanelHost& operator=(const PanelHost&) = delete;

  /// Begins the panels of one frame: draw them with ImGui's own calls after this.
  void BeginFrame(int width, int height, float seconds);
  /// Ends them; the next drawing of the scene shows them on top.
  void EndFrame();

  /// Draws the texts of panels anew for this size; 1 is 100 %. Not between BeginFrame and EndFrame.
  void SetTextScale(float scale);

  /// Dark letters on a light ground, or the other way.
  void SetLight(bool light);

  ImFont* FontFor(world::UiFont font) const { return script_fonts_[static_cast<std::size_t>(font)]; }
  ImFont* panel_font() const { return panel_font_; }
  ImFont* bold_font() const { return bold_font_; }
  ImFont* mono_font() const { return mono_font_; }

 private:
  void LoadFonts();

  Ogre::ImGuiOverlay* overlay_;  // The overlay manager owns it.
  std::array<ImFont*, 6> script_fonts_{};
  ImFont* panel_font_ = nullptr;
  ImFont* bold_font_ = nullptr;
  ImFont* mono_font_ = nullptr;
  float scale_ = 1;
  std::set<std::string> told_cut_;  ///< Windows that held too much to be drawn whole.
  bool light_ = false;
};

}  // namespace soarbox::viewer
