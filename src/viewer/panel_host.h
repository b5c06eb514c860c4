// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <set>
#include <string>

#include "viewer/materials.h"
#include "viewer/ogre_headers.h"

namespace soarbox::viewer {

/// Owns ImGui's overlay, its fonts and its input. Only one may exist at a time, because ImGui has one context.
class PanelHost {
 public:
  explicit PanelHost(Materials& materials);
  ~PanelHost();
  PanelHost(const PanelHost&) = delete;
  PanelHost& operator=(const PanelHost&) = delete;

  /// Begins the panels of a frame. Draw them with ImGui's own calls after this.
  void BeginFrame(int width, int height, float seconds);
  /// Ends them. The next drawing of the scene shows them on top.
  void EndFrame();

  /// Renders the fonts of panels again in this size; 1 is 100 %. Not between BeginFrame and EndFrame.
  void SetTextScale(float scale);

  /// Selects dark text on a light background, or light text on a dark one.
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
  std::set<std::string> told_cut_;  ///< Windows with too many vertices, already reported.
  bool light_ = false;
};

}  // namespace soarbox::viewer
