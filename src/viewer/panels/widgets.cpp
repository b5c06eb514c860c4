// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <iterator>

#include "diagnostics/plain_text.h"
#include "viewer/panels/layout_audit.h"

namespace soarbox::viewer {
namespace {

/// Lets a field write into a string of any length.
int GrowText(ImGuiInputTextCallbackData* data) {
  if (data->EventFlag != ImGuiInputTextFlags_CallbackResize) return 0;
  auto* text = static_cast<std::string*>(data->UserData);
  text->resize(static_cast<std::size_t>(data->BufTextLen));
  data->Buf = text->data();
  return 0;
}

bool IsPressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

bool wants_focus = false;
int list_frame = -1;  ///< The frame in which a list last had the keys.
int kept_frame = -1;  ///< The frame in which a field last kept the keyboard.

}  // namespace

void FocusNextField(bool wanted) {
  wants_focus = wanted;
}

bool IsFocusWanted() {
  return wants_focus;
}

void TakeFocus() {
  if (wants_focus) ImGui::SetKeyboardFocusHere();
  wants_focus = false;
}

void KeepKeyboard() {
  kept_frame = ImGui::GetFrameCount();
}

bool KeyboardIsKept() {
  return kept_frame >= 0 && kept_frame + 1 >= ImGui::GetFrameCount();
}

std::optional<std::size_t> StepInList(std::size_t count, const std::function<bool(std::size_t)>& is_chosen) {
  if (count == 0 || !ImGui::IsWindowFocused() || ImGui::GetIO().WantTextInput) return std::nullopt;
  list_frame = ImGui::GetFrameCount();
  const int step = (IsPressed(ImGuiKey_DownArrow) ? 1 : 0) - (IsPressed(ImGuiKey_UpArrow) ? 1 : 0);
  if (step == 0) return std::nullopt;
  std::size_t row = 0;
  while (row < count && !is_chosen(row)) ++row;
  if (row == count)
    row = step > 0 ? 0 : count - 1;
  else if (step > 0)
    row = std::min(row + 1, count - 1);
  else
    row -= row > 0 ? 1 : 0;
  // The table's headings do not scroll.
  const float height = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const float top = height * static_cast<float>(row), room = ImGui::GetWindowHeight() - 2 * height;
  if (top < ImGui::GetScrollY()) ImGui::SetScrollY(top);
  if (top > ImGui::GetScrollY() + room) ImGui::SetScrollY(top - room);
  return row;
}

bool ListTakesArrows() {
  return list_frame >= 0 && list_frame + 1 >= ImGui::GetFrameCount();
}

void ColoredText(ImVec4 color, std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
}

void WrappedText(std::string_view text) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
}

void WrappedText(ImVec4 color, std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  WrappedText(text);
  ImGui::PopStyleColor();
}

void FoldedText(const char* id, std::string_view text, ImVec4 color) {
  constexpr std::size_t kShort = 160;
  const std::size_t line_end = text.find('\n');
  if (text.size() <= kShort && line_end == std::string_view::npos) return WrappedText(color, text);
  ImGui::PushID(id);
  bool* const open = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("open"));
  if (*open) {
    WrappedText(color, text);
  } else {
    WrappedText(color, std::string(Beginning(text, std::min(kShort, line_end))) + " ...");
  }
  if (Link("fold", *open ? "less" : "all of it")) *open = !*open;
  ImGui::PopID();
}

std::string FittingText(std::string_view text, float width) {
  const char* end = text.data() + text.size();
  if (ImGui::CalcTextSize(text.data(), end).x <= width) return std::string(text);
  const float dots = ImGui::CalcTextSize("...").x;
  const char* fits = text.data();
  ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), std::max(1.0f, width - dots), 0, text.data(), end, &fits);
  return std::string(text.data(), fits) + "...";
}

std::string CutBeforeNumber(const std::string& name, float width) {
  constexpr std::size_t kLongest = 6, kLeast = 3;
  const auto width_of = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  const std::size_t dash = name.rfind('-');
  if (width_of(name) <= width) return name;
  if (dash == std::string::npos || name.size() - dash > kLongest) return FittingText(name, width);
  const std::string number = "..." + name.substr(dash);
  std::size_t kept = dash;
  while (kept > kLeast && width_of(name.substr(0, kept) + number) > width) --kept;
  return std::string(Beginning(name, kept)) + number;
}

void CutText(std::string_view text, float width, ImVec4 color) {
  const std::string fits = FittingText(text, width);
  ColoredText(color, fits);
  if (fits == text) return;
  // A few letters are not enough to recognise a text.
  constexpr std::size_t kLeast = 4 + 3;
  if (fits.size() < kLeast) NoteTooSmall("'" + std::string(text) + "' is cut to '" + fits + "'");
  Tooltip(text);
}

void CutText(std::string_view text, ImVec4 color) {
  CutText(text, ImGui::GetContentRegionAvail().x, color);
}

void FlowLine(float next_width, float gap) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float space = gap < 0 ? ImGui::GetStyle().ItemSpacing.x : gap;
  if (ImGui::GetItemRectMax().x + space + next_width <= right) ImGui::SameLine(0, space);
}

float ButtonWidth(const char* label) {
  return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

bool Link(const char* id, std::string_view text, ImVec4 color) {
  ImGui::PushID(id);
  const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton("link", {std::max(1.0f, size.x), std::max(1.0f, size.y)});
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& out = *ImGui::GetWindowDrawList();
  PutText(out, corner, theme::Packed(color), text);
  if (hovered) {
    out.AddLine({corner.x, corner.y + size.y - 1}, {corner.x + size.x, corner.y + size.y - 1}, theme::Packed(color));
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  ImGui::PopID();
  return clicked;
}

bool LitButton(const char* label, bool is_on, std::string_view tip) {
  if (is_on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  const bool clicked = ImGui::Button(label);
  if (is_on) ImGui::PopStyleColor();
  Tooltip(tip);
  return clicked;
}

bool ButtonIf(bool enabled, const char* label, std::string_view tip) {
  ImGui::BeginDisabled(!enabled);
  const bool clicked = ImGui::Button(label);
  ImGui::EndDisabled();
  Tooltip(tip);
  return clicked;
}

bool WasEntered() {
  return ImGui::IsItemDeactivated() && IsPressed(ImGuiKey_Enter);
}

bool ClickedLikeALink() {
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  return ImGui::IsItemClicked();
}

void Tooltip(std::string_view text) {
  if (text.empty() || !ImGui::IsItemHovered() || ImGui::GetIO().MouseDown[0]) return;
  // No tooltip while the mouse only passes by.
  constexpr float kWait_s = 0.35f;
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.HoveredId != 0 && context.HoveredIdTimer < kWait_s) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 26);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

bool SearchField(const char* id, const char* hint, std::string& text, float right) {
  ImGui::SetNextItemWidth(right > 0 ? -right : -1);
  TakeFocus();
  const bool changed = ImGui::InputTextWithHint(id, hint, text.data(), text.capacity() + 1,
                                                ImGuiInputTextFlags_CallbackResize, GrowText, &text);
  MayCut(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  constexpr float kLeast_em = 5;
  if (ImGui::GetItemRectSize().x < kLeast_em * ImGui::GetFontSize())
    NoteTooSmall("the field '" + std::string(hint) + "' has no room to type in");
  if (ImGui::CalcTextSize(hint).x + 2 * ImGui::GetStyle().FramePadding.x > ImGui::GetItemRectSize().x) Tooltip(hint);
  return changed;
}

List::List(const std::string& id, std::span<const ListColumn> columns, ImGuiTableFlags flags, float height)
    : is_open_(ImGui::BeginTable(id.c_str(), static_cast<int>(columns.size()), flags, {0, height})) {
  if (!is_open_) return;
  if ((flags & ImGuiTableFlags_ScrollY) != 0) ImGui::TableSetupScrollFreeze(0, 1);
  for (const ListColumn& column : columns) ImGui::TableSetupColumn(column.name, column.flags, column.width, column.id);
  ImGui::TableHeadersRow();
}

FactTable::FactTable(const char* id, float width_px, ImGuiTableFlags flags)
    : is_open_(ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingFixedFit | flags)) {
  if (!is_open_) return;
  ImGui::TableSetupColumn("name", width_px > 0 ? ImGuiTableColumnFlags_WidthFixed : 0, width_px);
  ImGui::TableSetupColumn("is", ImGuiTableColumnFlags_WidthStretch);
}

bool FactTable::Name(std::string_view name, ImVec4 color) const {
  if (!is_open_) return false;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ColoredText(color, name);
  ImGui::TableNextColumn();
  return true;
}

void EmptyNote(std::string_view what, std::string_view advice) {
  ImGui::Dummy({1, ImGui::GetFontSize() * 0.5f});
  WrappedText(theme::kText, what);
  if (!advice.empty()) WrappedText(theme::kQuiet, advice);
}

void BeginOver(const char* name, bool* is_open, ImGuiWindowFlags flags) {
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::Begin(name, is_open,
               flags | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleColor();
}

void BeginFixed(const char* name, ImVec2 corner, ImVec2 size) {
  ImGui::SetNextWindowPos(corner);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
}

double RoundStep_s(double least_s) {
  constexpr double kSteps_s[] = {0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 3600, 7200, 36000};
  const auto found = std::find_if(std::begin(kSteps_s), std::prev(std::end(kSteps_s)),
                                  [least_s](double step_s) { return step_s >= least_s; });
  return *found;
}

void Heading(PanelFrame& frame, std::string_view text, ImVec4 color) {
  const FontScope bold(frame.fonts.bold);
  ColoredText(color, text);
}

void Tag(std::string_view text, ImVec4 color) {
  const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
  const float pad = ImGui::GetFontSize() * 0.3f;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& out = *ImGui::GetWindowDrawList();
  out.AddRectFilled(at, {at.x + size.x + 2 * pad, at.y + size.y}, theme::Packed(color, 0.18f), 3);
  PutText(out, {at.x + pad, at.y}, theme::Packed(color), text);
  ImGui::Dummy({size.x + 2 * pad, size.y});
}

bool HasPart(std::string_view text, std::string_view part) {
  return FindPart(text, part) != std::string_view::npos;
}

std::size_t FindPart(std::string_view text, std::string_view part, std::size_t begin) {
  if (begin > text.size()) return std::string_view::npos;
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  const std::string_view rest = text.substr(begin);
  const auto found = std::search(rest.begin(), rest.end(), part.begin(), part.end(), same);
  if (found == rest.end() && !part.empty()) return std::string_view::npos;
  return begin + static_cast<std::size_t>(found - rest.begin());
}

std::string TimeOf(const PanelFrame& frame, std::uint64_t tick) {
  return TimeText(static_cast<double>(tick) * frame.contents.moment.step_s);
}

std::string TimeText(double time_s) {
  const int minutes = static_cast<int>(time_s / 60);
  return Formatted("%d:%05.2f", minutes, time_s - 60.0 * minutes);
}

}  // namespace soarbox::viewer
