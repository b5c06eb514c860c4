// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "viewer/panels/panel.h"
#include "viewer/panels/theme.h"

namespace soarbox::viewer {

/// Small elements that panels share.

/// Text in a colour.
void ColoredText(ImVec4 color, std::string_view text);
/// Text that wraps at the panel's edge.
void WrappedText(std::string_view text);
void WrappedText(ImVec4 color, std::string_view text);
/// Text whose first lines are shown, and the rest once it is unfolded.
void FoldedText(const char* id, std::string_view text, ImVec4 color);
/// Shortens "CrowdSeeker-12" to "CrowdS...-12" if it is too wide. The number distinguishes agents with similar names.
std::string CutBeforeNumber(const std::string& name, float width);
/// As much of a text as fits into `width` px, with "..." if it is cut.
std::string FittingText(std::string_view text, float width);
/// Text that is cut with "..." at `width` px; complete in a tooltip.
void CutText(std::string_view text, float width, ImVec4 color = theme::kText);
/// The same for the remaining width.
void CutText(std::string_view text, ImVec4 color = theme::kText);
/// Places the next item next to the previous one if there is space, else below it.
void FlowLine(float next_width, float gap = -1);
/// The width of a button with this label.
float ButtonWidth(const char* label);
/// Text that can be clicked; it looks like a link while the mouse is over it.
bool Link(const char* id, std::string_view text, ImVec4 color = theme::kAccent);
/// A button that looks pressed while `is_on`.
bool LitButton(const char* label, bool is_on, std::string_view tip);
/// A button that is grey unless it is `enabled`.
bool ButtonIf(bool enabled, const char* label, std::string_view tip);
/// Whether Enter ended the last field.
bool WasEntered();
/// Whether the last item was clicked; it looks like a link.
bool ClickedLikeALink();
/// Tooltip of the previous item, shown after a moment.
void Tooltip(std::string_view text);
/// A field with a hint. Returns true when its text changed. Uses the remaining width, less `right` px.
bool SearchField(const char* id, const char* hint, std::string& text, float right = 0);
/// Gives the keyboard to the next field of the current panel.
void FocusNextField(bool wanted = true);
/// Whether no field has taken the keyboard yet.
bool IsFocusWanted();
/// For fields of other kinds: call it before the field is drawn.
void TakeFocus();
/// The current field keeps the keyboard when the picture is clicked, because its text has not been sent.
void KeepKeyboard();
bool KeyboardIsKept();
/// Whether a list that was clicked uses the arrow keys, so that they do not move the camera.
bool ListTakesArrows();
/// A note in the middle of an empty panel, with advice.
void EmptyNote(std::string_view what, std::string_view advice = {});
/// A scope that ends at the end of its block.
struct Scope {
  Scope() = default;
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;
};
/// A part of the panel with its own scrolling, until the end of the block.
class Part : Scope {
 public:
  explicit Part(const char* id, ImVec2 size = {0, 0}, ImGuiWindowFlags flags = 0) {
    ImGui::BeginChild(id, size, false, ImGuiWindowFlags_NoNav | flags);
  }
  ~Part() { ImGui::EndChild(); }
};
/// Adds this id to the ids of everything that is drawn until the end of the block.
class IdScope : Scope {
 public:
  explicit IdScope(int id) { ImGui::PushID(id); }
  explicit IdScope(const char* id) { ImGui::PushID(id); }
  explicit IdScope(const std::string& id) { ImGui::PushID(id.c_str()); }
  explicit IdScope(const void* id) { ImGui::PushID(id); }
  ~IdScope() { ImGui::PopID(); }
};
/// Texts are drawn in this font until the end of the block.
class FontScope : Scope {
 public:
  explicit FontScope(ImFont* font) { ImGui::PushFont(font); }
  ~FontScope() { ImGui::PopFont(); }
};
/// A column of a table.
struct ListColumn {
  const char* name;
  float width = 0;  ///< Its fraction of the table's width, or px if a flag says so.
  ImGuiTableColumnFlags flags = 0;
  ImGuiID id = 0;  ///< For sorting.
};
/// A table, until the end of the block; false: it is not visible.
class List : Scope {
 public:
  static constexpr ImGuiTableFlags kUsual =
      ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp;
  /// Scrolls below a row of headings.
  List(const std::string& id, std::span<const ListColumn> columns, ImGuiTableFlags flags = kUsual, float height = 0);
  List(const std::string& id, std::initializer_list<ListColumn> columns, ImGuiTableFlags flags = kUsual,
       float height = 0)
      : List(id, std::span(columns.begin(), columns.size()), flags, height) {}
  ~List() {
    if (is_open_) ImGui::EndTable();
  }
  explicit operator bool() const { return is_open_; }

 private:
  bool is_open_;
};
/// Names and values in two columns, until the end of the block.
class FactTable : Scope {
 public:
  /// `width_px` is the width of the names; 0: the width of the longest.
  explicit FactTable(const char* id, float width_px = 0, ImGuiTableFlags flags = 0);
  ~FactTable() {
    if (is_open_) ImGui::EndTable();
  }
  /// Begins a row; the next item is the value of the name. False: there is no table.
  bool Name(std::string_view name, ImVec4 color = theme::kQuiet) const;
  void Row(std::string_view name, std::string_view is, ImVec4 color = theme::kText) const {
    if (Name(name)) WrappedText(color, is);
  }

 private:
  bool is_open_;
};
/// Draws the visible rows of `count` rows of equal height.
void ForRowsInSight(std::size_t count, auto&& draw, float height = -1) {
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count), height);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw(i);
}
/// For the list that was clicked last: returns the row that the arrow keys select, starting from the one for which
/// `is_chosen` is true, and scrolls to it. Nothing if no arrow key was pressed.
std::optional<std::size_t> StepInList(std::size_t count, const std::function<bool(std::size_t)>& is_chosen);
/// A window over all others, with the background of menus; ImGui::End ends it.
void BeginOver(const char* name, bool* is_open = nullptr, ImGuiWindowFlags flags = 0);
/// A window at a fixed place; ImGui::End ends it.
void BeginFixed(const char* name, ImVec2 corner, ImVec2 size);
/// Returns the smallest of the steps 0.1, 0.2, 0.5, 1, ... seconds, minutes, hours that is at least `least_s`.
double RoundStep_s(double least_s);
/// A heading within a panel.
void Heading(PanelFrame& frame, std::string_view text, ImVec4 color = theme::kText);
/// A short word on a coloured background.
void Tag(std::string_view text, ImVec4 color);
/// Whether the text contains the part, ignoring case.
bool HasPart(std::string_view text, std::string_view part);
/// Index of the next occurrence from `begin` on; npos: none.
std::size_t FindPart(std::string_view text, std::string_view part, std::size_t begin = 0);

std::string Formatted(const char* format, auto... values) {
  char text[256];
  const int length = std::snprintf(text, sizeof text, format, values...);
  return length < 0 ? std::string() : std::string(text);
}

/// "0:12.30" minutes, seconds.
std::string TimeText(double time_s);
/// The time of a tick of the run.
std::string TimeOf(const PanelFrame& frame, std::uint64_t tick);

}  // namespace soarbox::viewer
