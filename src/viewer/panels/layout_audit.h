// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::viewer {

/// Faults of ImGui's present frame that a user would see: texts and windows that are cut where nothing can
/// be scrolled, texts that lie over each other, and fixed windows that do or that leave the display. Each a sentence;
/// empty: all is well.
///
/// Call it between ImGui::Render and the next NewFrame. For tests and scripts of the window.
std::vector<std::string> AuditLayout(const ImFontAtlas& fonts);

/// Draws a text by hand, and notes for the audit where it stands: ImGui keeps nothing of what lies beyond a clipping
/// rectangle, and no item tells how far such a text reaches.
void PutText(ImDrawList& out, ImVec2 at, ImU32 color, std::string_view text);

/// Something in this frame is too small to be of use, or is left out because there is no room: a sentence for the
/// audit.
void NoteTooSmall(std::string what);

/// Texts within this part of the window are cut on purpose in this frame (a bar of the timeline, a field that scrolls).
void MayCut(ImVec2 corner, ImVec2 end);

}  // namespace soarbox::viewer
