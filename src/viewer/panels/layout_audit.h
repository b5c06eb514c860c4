// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::viewer {

/// Finds visible faults in ImGui's current frame: texts and windows that are cut although they cannot be scrolled,
/// texts that overlap, and fixed windows that overlap or leave the display. Returns a sentence for each fault.
///
/// Call it between ImGui::Render and the next NewFrame. For tests and scripts of the window.
std::vector<std::string> AuditLayout(const ImFontAtlas& fonts);

/// Draws a text and notes its place for the audit. ImGui drops everything outside of the clipping rectangle, and no
/// item contains the extent of such a text.
void PutText(ImDrawList& out, ImVec2 at, ImU32 color, std::string_view text);

/// Reports to the audit, as a sentence, that something in this frame is too small to be used or was left out for lack
/// of space.
void NoteTooSmall(std::string what);

/// Marks a part of the window in which texts are cut on purpose in this frame (a bar of the timeline, a field that
/// scrolls).
void MayCut(ImVec2 corner, ImVec2 end);

}  // namespace soarbox::viewer
