// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/layout_audit.h"

#include <imgui_internal.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "viewer/panels/text_capture.h"

namespace soarbox::viewer {
namespace {

/// Tolerance for the rounding of letters and borders, px.
constexpr float kSlack_px = 2.5f;

struct CutPlaces {
  int frame = -1;
  std::vector<ImRect> places;
};
CutPlaces cut_places;

/// Texts drawn with PutText(), with the clipping rectangles at that time.
struct PutTexts {
  int frame = -1;
  struct Text {
    const ImDrawList* list;
    ImRect box, clip;
    std::string text;
  };
  std::vector<Text> texts;
};
PutTexts put_texts;

/// Reports of panels (NoteTooSmall).
struct TooSmall {
  int frame = -1;
  std::vector<std::string> found;
};
TooSmall too_small;

std::string WindowName(const ImGuiWindow& window) {
  // From "Panels at the right/mind_1A2B/tree_3C4D", without the numbers.
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
  // These windows cover others on purpose.
  for (const std::string_view name : {"Find", "Close the window?", "Keys and mouse"})
    if (window.Name == name) return true;
  return (window.Flags & (ImGuiWindowFlags_Popup | ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_Modal)) != 0;
}

/// Whether the parts outside of the window can be scrolled into view, by this window or by one that contains it.
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

bool MayBeCut(const ImRect& text) {
  const float middle = (text.Min.y + text.Max.y) / 2;
  if (cut_places.frame != ImGui::GetFrameCount()) return false;
  return std::any_of(cut_places.places.begin(), cut_places.places.end(), [&](const ImRect& place) {
    return middle >= place.Min.y - kSlack_px && middle <= place.Max.y + kSlack_px &&
           text.Max.x >= place.Min.x - kSlack_px && text.Min.x <= place.Max.x + kSlack_px;
  });
}

/// The extent of texts drawn with PutText() is known, even if they are clipped.
void AuditPutTexts(const ImGuiWindow& window, std::vector<std::string>& found) {
  if (put_texts.frame != ImGui::GetFrameCount()) return;
  const ImRect inner = window.InnerRect;
  for (const PutTexts::Text& text : put_texts.texts) {
    if (text.list != window.DrawList || MayBeCut(text.box)) continue;
    const ImRect &box = text.box, &clip = text.clip;
    // Scrolling helps only if the window's own edge cuts the text, not a narrower clipping rectangle.
    const bool left = box.Min.x<clip.Min.x - kSlack_px, right = box.Max.x> clip.Max.x + kSlack_px;
    const bool above = box.Min.y<clip.Min.y - kSlack_px, below = box.Max.y> clip.Max.y + kSlack_px;
    const bool is_edge_x = left ? clip.Min.x <= inner.Min.x + kSlack_px : clip.Max.x >= inner.Max.x - kSlack_px;
    const bool is_edge_y = above ? clip.Min.y <= inner.Min.y + kSlack_px : clip.Max.y >= inner.Max.y - kSlack_px;
    const bool is_cut_x = (left || right) && !(is_edge_x && Scrolls(&window, 0));
    const bool is_cut_y = (above || below) && !(is_edge_y && Scrolls(&window, 1));
    if (is_cut_x || is_cut_y)
      found.push_back(WindowName(window) + ": the text '" + text.text + "', drawn by PutText, is cut");
  }
}

/// Letters over letters are illegible.
void AuditOverlaps(std::vector<std::pair<const ImGuiWindow*, ShownText>>& texts, std::vector<std::string>& found) {
  constexpr float kAcross_px = 4, kDown_px = 4;
  std::stable_sort(texts.begin(), texts.end(),
                   [](const auto& a, const auto& b) { return a.second.seen.y < b.second.seen.y; });
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const auto& [window, text] = texts[i];
    for (std::size_t k = i + 1; k < texts.size() && texts[k].second.seen.y < text.seen.w - kDown_px; ++k) {
      const auto& [other_window, other] = texts[k];
      if (window->RootWindow != other_window->RootWindow) continue;
      const float across = std::min(text.seen.z, other.seen.z) - std::max(text.seen.x, other.seen.x);
      const float down = std::min(text.seen.w, other.seen.w) - std::max(text.seen.y, other.seen.y);
      if (across > kAcross_px && down > kDown_px)
        found.push_back(WindowName(*window) + ": the texts '" + text.text + "' and '" + other.text +
                        "' lie over each other");
    }
  }
}

std::vector<ShownText> AuditTexts(const ImGuiWindow& window, const ImFontAtlas& fonts,
                                  std::vector<std::string>& found) {
  ImDrawData part;
  ImDrawList* list = window.DrawList;
  part.Valid = true;
  part.CmdLists = &list;
  part.CmdListsCount = 1;
  part.DisplaySize = ImGui::GetIO().DisplaySize;
  std::vector<ShownText> texts = CaptureText(part, fonts);
  for (const ShownText& text : texts) {
    if (!text.is_cut || MayBeCut({text.at.front(), text.top, text.at.back(), text.bottom})) continue;
    // A text is cut in a direction only if it cannot be scrolled in that direction.
    if ((text.is_cut_x && !Scrolls(&window, 0)) || (text.is_cut_y && !Scrolls(&window, 1)))
      found.push_back(WindowName(window) + ": the text '" + text.text + "' is cut");
  }
  return texts;
}

/// Things that are completely outside leave no trace in the drawing, but the window stores the size of its contents.
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
    found.push_back(WindowName(window) + ": its contents are " +
                    std::to_string(static_cast<int>(window.ContentSize.x)) + " px wide, but it has space for " +
                    std::to_string(static_cast<int>(room.x)));
  }
  if (window.ContentSize.y > room.y + window.WindowPadding.y && !Scrolls(&window, 1)) {
    found.push_back(WindowName(window) + ": its contents are " +
                    std::to_string(static_cast<int>(window.ContentSize.y)) + " px high, but it has space for " +
                    std::to_string(static_cast<int>(room.y)));
  }
}

/// A cell that is cut between two letters contains no cut letter.
void AuditTables(std::vector<std::string>& found) {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  for (int n = 0; n < context.Tables.GetMapSize(); ++n) {
    const ImGuiTable* table = context.Tables.TryGetMapData(n);
    if (table == nullptr || table->LastFrameActive < ImGui::GetFrameCount()) continue;
    for (int i = 0; i < table->ColumnsCount; ++i) {
      const ImGuiTableColumn& column = table->Columns[i];
      const float reached = std::max(column.ContentMaxXFrozen, column.ContentMaxXUnfrozen);
      if (!column.IsVisibleX || reached <= column.WorkMaxX + kSlack_px) continue;
      found.push_back(WindowName(*table->OuterWindow) + ": cells of column " + std::to_string(i + 1) + " are cut");
    }
  }
}

void AuditPlaces(const std::vector<const ImGuiWindow*>& fixed, std::vector<std::string>& found) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const ImRect a = fixed[i]->Rect();
    if (a.Min.x < -kSlack_px || a.Min.y < -kSlack_px || a.Max.x > display.x + kSlack_px ||
        a.Max.y > display.y + kSlack_px)
      found.push_back(WindowName(*fixed[i]) + ": leaves the window");
    for (std::size_t k = 0; k < i; ++k) {
      const ImRect b = fixed[k]->Rect();
      const float across = std::min(a.Max.x, b.Max.x) - std::max(a.Min.x, b.Min.x);
      const float down = std::min(a.Max.y, b.Max.y) - std::max(a.Min.y, b.Min.y);
      if (across > kSlack_px && down > kSlack_px)
        found.push_back(WindowName(*fixed[i]) + ": lies over " + WindowName(*fixed[k]));
    }
  }
}

}  // namespace

void PutText(ImDrawList& out, ImVec2 at, ImU32 color, std::string_view text) {
  const int frame = ImGui::GetFrameCount();
  if (put_texts.frame != frame) put_texts.texts.clear();
  put_texts.frame = frame;
  const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
  put_texts.texts.push_back(
      {&out, {at, {at.x + size.x, at.y + size.y}}, {out.GetClipRectMin(), out.GetClipRectMax()}, std::string(text)});
  out.AddText(at, color, text.data(), text.data() + text.size());
}

void NoteTooSmall(std::string what) {
  const int frame = ImGui::GetFrameCount();
  if (too_small.frame != frame) too_small.found.clear();
  too_small.frame = frame;
  if (std::find(too_small.found.begin(), too_small.found.end(), what) == too_small.found.end())
    too_small.found.push_back(std::move(what));
}

void MayCut(ImVec2 corner, ImVec2 end) {
  const int frame = ImGui::GetFrameCount();
  if (cut_places.frame != frame) cut_places.places.clear();
  cut_places.frame = frame;
  cut_places.places.emplace_back(corner, end);
}

std::vector<std::string> AuditLayout(const ImFontAtlas& fonts) {
  std::vector<std::string> found;
  if (too_small.frame == ImGui::GetFrameCount()) found = too_small.found;
  std::vector<const ImGuiWindow*> fixed;
  std::vector<std::pair<const ImGuiWindow*, ShownText>> texts;
  for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
    if (!IsShown(*window) || std::string_view(window->Name).starts_with("Debug##")) continue;
    for (ShownText& text : AuditTexts(*window, fonts, found)) texts.emplace_back(window, std::move(text));
    AuditPutTexts(*window, found);
    if (IsFloating(*window)) continue;
    AuditContent(*window, found);
    const bool is_child = (window->Flags & ImGuiWindowFlags_ChildWindow) != 0;
    if (!is_child) fixed.push_back(window);
  }
  AuditOverlaps(texts, found);
  AuditTables(found);
  AuditPlaces(fixed, found);
  return found;
}

}  // namespace soarbox::viewer
