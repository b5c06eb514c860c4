// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <string_view>

#include "viewer/panels/panel.h"
#include "viewer/panels/theme.h"

namespace soarbox::viewer {

/// Small things that panels share.

/// Text in a colour.
void ColoredText(ImVec4 color, std::string_view text);
/// Text that breaks at the panel's edge.
void WrappedText(std::string_view text);
void WrappedText(ImVec4 color, std::string_view text);
/// Text of which the first lines are shown, and the others once it is unfolded.
void FoldedText(const char* id, std::string_view text, ImVec4 color);
/// "CrowdSeeker-12" as "CrowdS...-12" where it is too long: of many who are named alike, the number tells who it is.
std::string CutBeforeNumber(const std::string& name, float width);
/// As much of a text as fits into `width` px, with "..." where it is cut.
std::string FittingText(std::string_view text, float width);
/// Text that is cut with "..." at `width` px; whole in a tooltip.
void CutText(std::string_view text, float width, ImVec4 color = theme::kText);
/// The same in the width that is left.
void CutText(std::string_view text, ImVec4 color = theme::kText);
/// Puts the next item beside the one before if it has room there, else below.
void FlowLine(float next_width, float gap = -1);
/// The width of a button with this label.
float ButtonWidth(const char* label);
/// Text that answers a click; looks like a link while the mouse is over it.
bool Link(const char* id, std::string_view text, ImVec4 color = theme::kAccent);
/// Shown over the item before, after a moment.
void Tooltip(std::string_view text);
/// A field with a hint; true when its text changed. Takes the width that is left, less `right` px.
bool SearchField(const char* id, const char* hint, std::string& text, float right = 0);
/// The next field that is drawn takes the keyboard: somebody wants to search, or to type, in the panel drawn now.
void FocusNextField(bool wanted = true);
/// For a field of its own kind: call before it is drawn.
void TakeFocus();
/// The field that is drawn now keeps the keyboard when the picture is clicked: a line in it is not sent yet.
void KeepKeyboard();
bool KeyboardIsKept();
/// In a list that was clicked last: -1 or 1 when the user wants the row above or below, by the arrow keys; else 0.
int ListStep();
/// Brings a row of a table of equal rows into view.
void ScrollToRow(int row);
/// Whether such a list takes the arrow keys, so that they do not move the camera.
bool ListTakesArrows();
/// What stands in the middle of a panel that has nothing to show, and what to do about it.
void EmptyNote(std::string_view what, std::string_view advice = {});
/// A column of a table.
struct ListColumn {
  const char* name;
  float width = 0;  ///< Its share of the table's width, or px if a flag says so.
  ImGuiTableColumnFlags flags = 0;
};
/// A table that scrolls below a row of headings; false: none of it is in sight. ImGui::EndTable ends it.
bool BeginList(const char* id, std::initializer_list<ListColumn> columns, ImGuiTableFlags flags = 0);
/// Draws those of so many rows of equal height that are in sight.
void ForRowsInSight(std::size_t count, auto&& draw, float height = -1) {
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count), height);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw(i);
}
/// A heading within a panel.
void Heading(PanelFrame& frame, std::string_view text);
/// A short word on a coloured ground.
void Tag(std::string_view text, ImVec4 color);
/// Whether the text holds the part, in upper or lower case.
bool HasPart(std::string_view text, std::string_view part);

std::string Formatted(const char* format, auto... values) {
  char text[256];
  const int length = std::snprintf(text, sizeof text, format, values...);
  return length < 0 ? std::string() : std::string(text);
}

/// A number without the zeros that say nothing, "39.5" for "39.500000"; other texts as they are.
std::string ShortNumber(std::string_view text);

/// "0:12.30" minutes, seconds.
std::string TimeText(double time_s);

}  // namespace soarbox::viewer
