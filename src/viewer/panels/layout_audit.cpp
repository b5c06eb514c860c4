// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/layout_audit.h"

#include <imgui_internal.h>

#include <algorithm>
#include <string_view>

#include "viewer/panels/text_capture.h"

namespace soarbox::viewer {
namespace {

/// Rounding of letters and borders, px.
constexpr float kSlack_px = 2.5f;

struct CutPlaces {
  int frame = -1;
  std::vector<ImRect> places;
};
CutPlaces cut_places;

std::string NameOf(const ImGuiWindow& window) {
  // "Panels at the right/mind_1A2B/tree_3C4D": the numbers say nothing.
  std::string name;
  std::string_view rest = window.Name;
  while (!rest.empty()) {
    const std::string_view part = rest.substr(0, rest.find('/'));
    rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    name.append(name.empty() ? "" : "/").append(part.substr(0, part.rfind('_')));
  }
  return name;
}

bool IsShown(const ImGuiWindow& window) {
  return window.Active && !window.Hidden && window.Rect().GetWidth() > 1 && window.Rect().GetHeight() > 1;
}

bool IsFloating(const ImGuiWindow& window) {
  return (window.Flags & (ImGuiWindowFlags_Popup | ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_Modal)) != 0;
}

/// Whether what lies outside of the window can be brought into view, by it or by one that it lies in.
bool Scrolls(const ImGuiWindow* window, int axis) {
  constexpr ImGuiWindowFlags kNeverDown = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  for (; window != nullptr; window = window->ParentWindow) {
    const bool may = axis == 0 ? (window->Flags & ImGuiWindowFlags_HorizontalScrollbar) != 0
                               : (window->Flags & kNeverDown) != kNeverDown;
    if (may && window->ScrollMax[axis] > 0) return true;
    if ((window->Flags & ImGuiWindowFlags_ChildWindow) == 0) return false;
  }
  return false;
}

bool MayBeCut(const ShownText& text) {
  const ImVec2 middle{(text.at.front() + text.at.back()) / 2, (text.top + text.bottom) / 2};
  if (cut_places.frame != ImGui::GetFrameCount()) return false;
  return std::any_of(cut_places.places.begin(), cut_places.places.end(), [&](const ImRect& place) {
    return middle.y >= place.Min.y - kSlack_px && middle.y <= place.Max.y + kSlack_px &&
           text.at.back() >= place.Min.x - kSlack_px && text.at.front() <= place.Max.x + kSlack_px;
  });
}

void AuditTexts(const ImGuiWindow& window, const ImFontAtlas& fonts, std::vector<std::string>& found) {
  ImDrawData part;
  ImDrawList* list = window.DrawList;
  part.Valid = true;
  part.CmdLists = &list;
  part.CmdListsCount = 1;
  part.DisplaySize = ImGui::GetIO().DisplaySize;
  for (const ShownText& text : CaptureText(part, fonts)) {
    if (!text.is_cut || MayBeCut(text)) continue;
    // Which way it is cut shows in whether it can be scrolled that way.
    if ((text.is_cut_x && !Scrolls(&window, 0)) || (text.is_cut_y && !Scrolls(&window, 1)))
      found.push_back(NameOf(window) + ": the text '" + text.text + "' is cut");
  }
}

/// Things that are wholly outside leave no trace in what is drawn; but the window knows how far they reached.
void AuditContent(const ImGuiWindow& window, std::vector<std::string>& found) {
  const ImRect inner = window.InnerRect;
  const bool is_field = cut_places.frame == ImGui::GetFrameCount() &&
                        std::any_of(cut_places.places.begin(), cut_places.places.end(), [&](const ImRect& place) {
                          return inner.Min.x >= place.Min.x - kSlack_px && inner.Max.x <= place.Max.x + kSlack_px &&
                                 inner.Min.y >= place.Min.y - kSlack_px && inner.Max.y <= place.Max.y + kSlack_px;
                        });
  if (is_field) return;
  const ImVec2 room{window.InnerRect.GetWidth() - 2 * window.WindowPadding.x + kSlack_px,
                    window.InnerRect.GetHeight() - 2 * window.WindowPadding.y + kSlack_px};
  if (window.ContentSize.x > room.x + window.WindowPadding.x && !Scrolls(&window, 0)) {
    found.push_back(NameOf(window) + ": what stands in it is " +
                    std::to_string(static_cast<int>(window.ContentSize.x)) + " px wide, and it has room for " +
                    std::to_string(static_cast<int>(room.x)));
  }
  if (window.ContentSize.y > room.y + window.WindowPadding.y && !Scrolls(&window, 1)) {
    found.push_back(NameOf(window) + ": what stands in it is " +
                    std::to_string(static_cast<int>(window.ContentSize.y)) + " px high, and it has room for " +
                    std::to_string(static_cast<int>(room.y)));
  }
}

/// A cell that is cut between two letters shows no cut letter.
void AuditTables(std::vector<std::string>& found) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  for (int n = 0; n < context.Tables.GetMapSize(); ++n) {
    const ImGuiTable* table = context.Tables.TryGetMapData(n);
    if (table == nullptr || table->LastFrameActive < ImGui::GetFrameCount()) continue;
    for (int i = 0; i < table->ColumnsCount; ++i) {
      const ImGuiTableColumn& column = table->Columns[i];
      const float reached = std::max(column.ContentMaxXFrozen, column.ContentMaxXUnfrozen);
      if (!column.IsVisibleX || reached <= column.WorkMaxX + kSlack_px) continue;
      found.push_back(NameOf(*table->OuterWindow) + ": cells of column " + std::to_string(i + 1) + " are cut");
    }
  }
}

void AuditPlaces(const std::vector<const ImGuiWindow*>& fixed, std::vector<std::string>& found) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const ImRect a = fixed[i]->Rect();
    if (a.Min.x < -kSlack_px || a.Min.y < -kSlack_px || a.Max.x > display.x + kSlack_px ||
        a.Max.y > display.y + kSlack_px)
      found.push_back(NameOf(*fixed[i]) + ": leaves the window");
    for (std::size_t k = 0; k < i; ++k) {
      const ImRect b = fixed[k]->Rect();
      const float across = std::min(a.Max.x, b.Max.x) - std::max(a.Min.x, b.Min.x);
      const float down = std::min(a.Max.y, b.Max.y) - std::max(a.Min.y, b.Min.y);
      if (across > kSlack_px && down > kSlack_px)
        found.push_back(NameOf(*fixed[i]) + ": lies over " + NameOf(*fixed[k]));
    }
  }
}

}  // namespace

void MayCut(ImVec2 corner, ImVec2 end) {
  const int frame = ImGui::GetFrameCount();
  if (cut_places.frame != frame) cut_places.places.clear();
  cut_places.frame = frame;
  cut_places.places.emplace_back(corner, end);
}

std::vector<std::string> AuditLayout(const ImFontAtlas& fonts) {
  std::vector<std::string> found;
  std::vector<const ImGuiWindow*> fixed;
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    if (!IsShown(*window) || std::string_view(window->Name).starts_with("Debug##")) continue;
    AuditTexts(*window, fonts, found);
    if (IsFloating(*window)) continue;
    AuditContent(*window, found);
    const bool is_child = (window->Flags & ImGuiWindowFlags_ChildWindow) != 0;
    if (!is_child) fixed.push_back(window);
  }
  AuditTables(found);
  AuditPlaces(fixed, found);
  return found;
}

}  // namespace soarbox::viewer
