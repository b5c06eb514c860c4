// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

namespace soarbox::viewer {

/// The fonts of panels.
struct PanelFonts {
  ImFont* plain = nullptr;
  ImFont* bold = nullptr;
  ImFont* mono = nullptr;
};

/// Adds a system font to ImGui's atlas, or ImGui's own font if there is none with this name.
ImFont* AddFont(const char* file_name, float height_px);

/// Adds the fonts of the panels for this text size; 1 is 100 %.
PanelFonts AddPanelFonts(float scale);

}  // namespace soarbox::viewer
