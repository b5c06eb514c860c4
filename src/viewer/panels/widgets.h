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
/// A button that looks pressed while `is_on`.
bool LitButton(const char* label, bool is_on, std::string_view tip);
/// A button that is grey unless it is `enabled`.
bool ButtonIf(bool enabled, const char* label, std::string_view tip);
/// Whether Enter ended the field that was drawn last.
bool WasEntered();
/// The item that was drawn last answers clicks.
bool ClickedLikeALink();
/// Shown over the item before, after a moment.
void Tooltip(std::string_view text);
/// A field with a hint; true when its text changed. Takes the width that is left, less `right` px.
bool SearchField(const char* id, const char* hint, std::string& text, float right = 0);
/// The next field that is drawn takes the keyboard: somebody wants to search, or to type, in the panel drawn now.
void FocusNextField(bool wanted = true);
/// No field has taken it yet.
bool IsFocusWanted();
/// For a field of its own kind: call before it is drawn.
void TakeFocus();
/// The field that is drawn now keeps the keyboard when the picture is clicked: a line in it is not sent yet.
void KeepKeyboard();
bool KeyboardIsKept();
/// Whether a list that was clicked takes the arrow keys, so that they do not move the camera.
bool ListTakesArrows();
/// What stands in the middle of a panel that has nothing to show, and what to do about it.
void EmptyNote(std::string_view what, std::string_view advice = {});
/// Something that is open until the end of its block.
struct Scope {
  Scope() = default;
  Scope(const Scope&) = delete;
  Scope& operator=(const Scope&) = delete;
};
/// A part of the panel that scrolls by itself, until the end of the block.
class Part : Scope {
 public:
  explicit Part(const char* id, ImVec2 size = {0, 0}, ImGuiWindowFlags flags = 0) {
    ImGui::BeginChild(id, size, false, ImGuiWindowFlags_NoNav | flags);
  }
  ~Part() { ImGui::EndChild(); }
};
/// What is drawn until the end of the block has this in its ids.
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
  float width = 0;  ///< Its share of the table's width, or px if a flag says so.
  ImGuiTableColumnFlags flags = 0;
  ImGuiID id = 0;  ///< For sorting.
};
/// A table, until the end of the block; false: none of it is in sight.
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
/// Names and what they stand for, in two columns until the end of the block.
class FactTable : Scope {
 public:
  /// `width_px` of the names; 0: as wide as the longest.
  explicit FactTable(const char* id, float width_px = 0, ImGuiTableFlags flags = 0);
  ~FactTable() {
    if (is_open_) ImGui::EndTable();
  }
  /// Begins a row; what is drawn next stands beside the name. False: there is no table.
  bool Name(std::string_view name, ImVec4 color = theme::kQuiet) const;
  void Row(std::string_view name, std::string_view is, ImVec4 color = theme::kText) const {
    if (Name(name)) WrappedText(color, is);
  }

 private:
  bool is_open_;
};
/// Draws those of so many rows of equal height that are in sight.
void ForRowsInSight(std::size_t count, auto&& draw, float height = -1) {
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count), height);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) draw(i);
}
/// In a list that was clicked last: the row that the arrow keys lead to from the one that `is_chosen`, in view from now
/// on; nothing: none was pressed.
std::optional<std::size_t> StepInList(std::size_t count, const std::function<bool(std::size_t)>& is_chosen);
/// A window over all others, with the ground of menus; ImGui::End ends it.
void BeginOver(const char* name, bool* is_open = nullptr, ImGuiWindowFlags flags = 0);
/// A part of the window that stands where it is put; ImGui::End ends it.
void BeginFixed(const char* name, ImVec2 corner, ImVec2 size);
/// The next of such steps that is not smaller: 0.1, 0.2, 0.5, 1, ... seconds, minutes, hours.
double RoundStep_s(double least_s);
/// A heading within a panel.
void Heading(PanelFrame& frame, std::string_view text, ImVec4 color = theme::kText);
/// A short word on a coloured ground.
void Tag(std::string_view text, ImVec4 color);
/// Whether the text holds the part, in upper or lower case.
bool HasPart(std::string_view text, std::string_view part);
/// Where the text has it next, from `begin` on; npos: nowhere.
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
