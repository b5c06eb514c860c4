// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

namespace soarbox::viewer {

/// What panels write with.
struct PanelFonts {
  ImFont* plain = nullptr;
  ImFont* bold = nullptr;
  ImFont* mono = nullptr;
};

/// Adds a font of the system to ImGui's atlas; ImGui's own where there is none of this name.
ImFont* AddFont(const char* file_name, float height_px);

/// Those of the panels, for this text size; 1 is 100 %.
PanelFonts AddPanelFonts(float scale);

}  // namespace soarbox::viewer
