// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

namespace soarbox::viewer {

/// What of ImGui's present frame a user could not see as it was meant: texts and windows that are cut where nothing can
/// be scrolled, and fixed windows that lie over each other or leave the display. Each a sentence; empty: all is well.
///
/// Call it between ImGui::Render and the next NewFrame. For tests and scripts of the window.
std::vector<std::string> AuditLayout(const ImFontAtlas& fonts);

/// Texts within this part of the window are cut on purpose in this frame (a bar of the timeline, a field that scrolls).
void MayCut(ImVec2 corner, ImVec2 end);

}  // namespace soarbox::viewer
