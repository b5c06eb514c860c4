// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/panel_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/panels/document_panel.h"
#include "viewer/panels/icons.h"
#include "viewer/panels/layout_audit.h"
#include "viewer/panels/widgets.h"
#include "viewer/script_ui_places.h"
#include "workbench/document/panels.h"

namespace soarbox::viewer {
namespace {

constexpr float kGrip_px = 5;
constexpr const char* kPanelPayload = "soarbox-panel";

const char* Title(Area area) {
  constexpr const char* kTitles[] = {"Panels at the left", "Panels at the right", "Panels at the bottom"};
  return kTitles[static_cast<std::size_t>(area)];
}

}  // namespace

Workspace::Workspace(Layout new_layout) : layout(std::move(new_layout)) {
  const auto put = [this](workbench::PanelId id, std::unique_ptr<Panel> panel) {
    panels_[static_cast<std::size_t>(id)] = std::move(panel);
  };
  for (const workbench::PanelInfo& info : workbench::kPanelInfos)
    if (workbench::document::HasDocument(info.id)) put(info.id, std::make_unique<DocumentPanel>(info.id));
  put(workbench::PanelId::kTimeline, MakeTimelinePanel());
  put(workbench::PanelId::kEdit, MakeEditPanel());
}

Workspace::Metrics Workspace::Measure(int width, int height) const {
  Metrics m{};
  m.scale = static_cast<float>(layout.text_percent) / 100;
  m.width = static_cast<float>(width);
  m.height = static_cast<float>(height);
  m.menu = std::round(23 * m.scale);
  m.toolbar = std::round(36 * m.scale);
  m.scrubber = std::round(32 * m.scale);
  m.across = m.down = m.scale;
  if (only_picture) return m;
  // In a large window, panels grow with it.
  constexpr float kUsualWidth = 1280, kUsualHeight = 720, kMostShare = 1.3f;
  m.across = m.scale * std::clamp(m.width / (kUsualWidth * m.scale), 1.0f, kMostShare);
  m.down = m.scale * std::clamp(m.height / (kUsualHeight * m.scale), 1.0f, kMostShare);
  const auto size = [&](Area area, float most) {
    const AreaLayout& side = layout.at(area);
    if (!side.shown || side.panels.empty()) return 0.0f;
    const float unit = area == Area::kBottom ? m.down : m.across;
    return std::round(std::clamp(side.size * unit, 80 * m.scale, std::max(80 * m.scale, most)));
  };
  // The picture keeps at least a third of the window in each direction, even if the layout comes from a larger window.
  m.right = size(Area::kRight, 0.45f * m.width);
  m.left = size(Area::kLeft, std::max(0.0f, 0.67f * m.width - m.right));
  m.bottom = size(Area::kBottom, 0.67f * m.height - m.top() - m.scrubber);
  return m;
}

PictureRect Workspace::PictureIn(int width, int height) const {
  const Metrics m = Measure(width, height);
  PictureRect rect;
  rect.x = static_cast<int>(m.left);
  rect.y = static_cast<int>(m.top());
  rect.width = std::max(1, static_cast<int>(m.width - m.left - m.right));
  rect.height = std::max(1, static_cast<int>(m.floor() - m.top()));
  return rect;
}

void Workspace::Draw(PanelFrame& frame, int width, int height, float frames_per_second) {
  const Metrics m = Measure(width, height);
  DrawMenus(frame);
  DrawToolbar(frame, m, frames_per_second);
  DrawScrubber(frame, m);
  for (const Area area : {Area::kLeft, Area::kRight, Area::kBottom}) DrawArea(frame, area, m);
  if (std::exchange(wants_copy_, false)) Copy(frame, used_);
  cover_ = {0, 0, 0, 0};
  if (layout.first_steps && !only_picture) {
    const PictureRect picture = PictureIn(width, height);
    const auto x = static_cast<float>(picture.x), y = static_cast<float>(picture.y),
               wide = static_cast<float>(picture.width), high = static_cast<float>(picture.height);
    std::vector<ScreenBox> taken = BoxesOfScriptUi(frame.scene, {wide, high, m.width, m.height});
    for (ScreenBox& box : taken) box = {box.left + x, box.top + y, box.right + x, box.bottom + y};
    const ScreenBox strip = DrawFirstSteps(frame, first_steps_, {x, y, x + wide, y + high}, taken);
    cover_ = {static_cast<int>(strip.left), static_cast<int>(strip.top), static_cast<int>(strip.width()),
              static_cast<int>(strip.height())};
  }
  if (show_help) DrawHelp(frame, width, height);
  finder_.Draw(frame, m.width, m.height, finder_.is_open() ? Actions(frame) : std::vector<Finder::Action>{});
  closing_.Draw(frame, m.width, m.height);
  modal_ = show_help || closing_.is_open() || finder_.is_open() ||
           ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

void Workspace::DrawArea(PanelFrame& frame, Area area, const Metrics& m) {
  ImVec2 corner, size;
  switch (area) {
    case Area::kLeft:
      corner = {0, m.top()};
      size = {m.left, m.height - m.scrubber - m.top()};
      break;
    case Area::kRight:
      corner = {m.width - m.right, m.top()};
      size = {m.right, m.height - m.scrubber - m.top()};
      break;
    case Area::kBottom:
      corner = {m.left, m.floor()};
      size = {m.width - m.left - m.right, m.bottom};
      break;
  }
  if (size.x < 1 || size.y < 1) return;
  BeginFixed(Title(area), corner, size);
  DrawTabs(frame, area);
  AreaLayout& side = layout.at(area);
  if (side.front < side.panels.size()) {
    const workbench::PanelId panel = side.panels[side.front];
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {2, 2});
    const Part part(InfoOf(panel).word.data());
    ImGui::PopStyleVar();
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    constexpr ImGuiHoveredFlags kOver = ImGuiHoveredFlags_ChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem;
    if ((moved.x != 0 || moved.y != 0) && ImGui::IsWindowHovered(kOver)) used_ = panel;
    FocusNextField(focus_ == panel);
    if (Panel* drawn = panels_[static_cast<std::size_t>(panel)].get()) drawn->Draw(frame);
    // A panel that was just opened may have its field some frames later.
    constexpr int kPatience_frames = 30;
    if (focus_ == panel && (!IsFocusWanted() || ++focus_waits_ > kPatience_frames)) focus_.reset();
    FocusNextField(false);
  }
  DrawSplitter(area, corner, size, m);
  ImGui::End();
}

namespace {

/// "Problems 3"
std::string TitleOf(workbench::PanelId panel, const workbench::Contents& contents) {
  std::string title(InfoOf(panel).title);
  const std::string badge = workbench::document::BadgeOf(panel, contents);
  return badge.empty() ? title : title + " " + badge;
}

ImVec2 SizeOfTab(const std::string& title) {
  const ImVec2 pad = ImGui::GetStyle().FramePadding, text = ImGui::CalcTextSize(title.c_str());
  return {text.x + 1.6f * pad.x, text.y + 1.6f * pad.y};
}

/// Chooses the panels of an area that get a tab. All of them, in several rows if necessary. If the rows would leave too
/// little space for the panel, only those that fit into one row; a menu has the others. The front panel always has a
/// tab.
std::vector<workbench::PanelId> WithTabs(const AreaLayout& side, const workbench::Contents& contents, float gap) {
  constexpr float kLow_em = 17;
  if (ImGui::GetContentRegionAvail().y > kLow_em * ImGui::GetFontSize()) return side.panels;
  const float room = ImGui::GetContentRegionAvail().x, more = SizeOfTab("+88").x + gap;
  std::vector<workbench::PanelId> shown;
  float taken = 0;
  for (std::size_t i = 0; i < side.panels.size(); ++i) {
    const float width = SizeOfTab(TitleOf(side.panels[i], contents)).x + gap;
    const bool is_last = i + 1 == side.panels.size();
    if (taken + width + (is_last ? 0 : more) > room) break;
    taken += width;
    shown.push_back(side.panels[i]);
  }
  if (side.front >= side.panels.size()) return shown;
  const workbench::PanelId front = side.panels[side.front];
  if (std::find(shown.begin(), shown.end(), front) != shown.end()) return shown;
  for (const float width = SizeOfTab(TitleOf(front, contents)).x + gap; !shown.empty() && taken + width + more > room;
       shown.pop_back())
    taken -= SizeOfTab(TitleOf(shown.back(), contents)).x + gap;
  shown.push_back(front);
  return shown;
}

}  // namespace

/// A menu with the panels of an area that have no tab.
void Workspace::DrawOtherTabs(PanelFrame& frame, const std::vector<workbench::PanelId>& panels,
                              const std::vector<workbench::PanelId>& shown) {
  if (shown.size() == panels.size()) return;
  const std::string title = "+" + std::to_string(panels.size() - shown.size());
  const ImVec2 size = SizeOfTab(title), pad = ImGui::GetStyle().FramePadding;
  ImGui::SameLine(0, frame.Px(2));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton("more", size)) ImGui::OpenPopup("other panels");
  const bool hovered = ImGui::IsItemHovered();
  Tooltip("More panels that are open here");
  PutText(*ImGui::GetWindowDrawList(), {at.x + 0.8f * pad.x, at.y + 0.8f * pad.y},
          theme::Packed(hovered ? theme::kText : theme::kAccent), title);
  if (!ImGui::BeginPopup("other panels")) return;
  for (const workbench::PanelId panel : panels) {
    if (std::find(shown.begin(), shown.end(), panel) != shown.end()) continue;
    if (ImGui::MenuItem(TitleOf(panel, frame.contents).c_str(), ("Alt+" + std::string(1, InfoOf(panel).key)).c_str()))
      layout.Show(panel);
  }
  ImGui::EndPopup();
}

void Workspace::DrawTabs(PanelFrame& frame, Area area) {
  AreaLayout& side = layout.at(area);
  const ImVec2 pad = ImGui::GetStyle().FramePadding;
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x, gap = frame.Px(2);
  const std::vector<workbench::PanelId> all = side.panels, panels = WithTabs(side, frame.contents, gap);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const workbench::PanelInfo& info = InfoOf(panels[i]);
    const bool is_front = side.front < all.size() && panels[i] == all[side.front];
    const bool alarms =
        panels[i] == workbench::PanelId::kProblems && !workbench::document::BadgeOf(panels[i], frame.contents).empty();
    const std::string title = TitleOf(panels[i], frame.contents);
    const ImVec2 size = SizeOfTab(title);
    if (i > 0) {
      ImGui::SameLine(0, gap);
      if (ImGui::GetCursorScreenPos().x + size.x > right) ImGui::NewLine();
    }
    const IdScope id(info.word.data());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton("tab", size)) layout.Show(panels[i]);
    const bool hovered = ImGui::IsItemHovered();
    Tooltip(std::string(info.about) + "  (Alt+" + info.key + ")");
    if (ImGui::BeginDragDropSource()) {
      ImGui::SetDragDropPayload(kPanelPayload, &panels[i], sizeof panels[i]);
      ImGui::TextUnformatted(info.title.data());
      ImGui::EndDragDropSource();
    }
    DrawTabMenu(frame, panels[i]);
    ImDrawList& out = *ImGui::GetWindowDrawList();
    const ImVec2 end{at.x + size.x, at.y + size.y};
    if (is_front || hovered) {
      out.AddRectFilled(at, end, theme::Packed(is_front ? theme::kRaised : theme::kAccent, is_front ? 1.0f : 0.12f), 4,
                        ImDrawFlags_RoundCornersTop);
    }
    if (is_front) out.AddRectFilled({at.x, end.y - frame.Px(2)}, end, theme::Packed(theme::kAccent));
    const ImVec4 color = alarms ? theme::kBad : is_front ? theme::kText : theme::kQuiet;
    PutText(out, {at.x + 0.8f * pad.x, at.y + 0.8f * pad.y}, theme::Packed(color), title);
  }
  DrawOtherTabs(frame, all, panels);
  const ImVec2 line = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddLine({line.x, line.y - ImGui::GetStyle().ItemSpacing.y},
                                      {right, line.y - ImGui::GetStyle().ItemSpacing.y}, theme::Packed(theme::kEdge));
  // A tab dropped anywhere in the area moves to this area.
  const ImGuiPayload* payload = ImGui::GetDragDropPayload();
  if (payload == nullptr || !payload->IsDataType(kPanelPayload)) return;
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  if (!ImGui::IsMouseHoveringRect(corner, {corner.x + size.x, corner.y + size.y}, false)) return;
  ImGui::GetForegroundDrawList()->AddRect(corner, {corner.x + size.x, corner.y + size.y}, theme::Packed(theme::kAccent),
                                          0, 0, frame.Px(2));
  const workbench::PanelId dropped = *static_cast<const workbench::PanelId*>(payload->Data);
  const bool is_here = std::find(side.panels.begin(), side.panels.end(), dropped) != side.panels.end();
  if (ImGui::IsMouseReleased(0) && !is_here) layout.Move(dropped, area);
}

bool Workspace::MayClose(const workbench::Contents& contents) {
  std::vector<std::string> unsent;
  for (const auto& panel : panels_) {
    if (std::string text = panel->Unsent(); !text.empty()) unsent.push_back(std::move(text));
  }
  return closing_.MayClose(contents, std::move(unsent));
}

void Workspace::Open(workbench::PanelId panel) {
  only_picture = false;
  layout.Show(panel);
  used_ = panel;
  focus_ = panel;
  focus_waits_ = 0;
}

void Workspace::Copy(PanelFrame& frame, workbench::PanelId panel) {
  const std::string text = panels_[static_cast<std::size_t>(panel)]->Text(frame);
  const std::string title(InfoOf(panel).title);
  if (text.empty()) {
    frame.Ask(workbench::TellRequest{title + ": there is nothing to copy"});
    return;
  }
  ImGui::SetClipboardText(text.c_str());
  const auto lines = std::count(text.begin(), text.end(), '\n') + (text.back() == '\n' ? 0 : 1);
  frame.Ask(workbench::TellRequest{title + ": copied " + std::to_string(lines) + (lines == 1 ? " line" : " lines")});
}

void Workspace::DrawTabMenu(PanelFrame& frame, workbench::PanelId panel) {
  if (!ImGui::BeginPopupContextItem("menu")) return;
  if (ImGui::MenuItem("Copy what it shows", "Ctrl+C")) Copy(frame, panel);
  ImGui::Separator();
  for (const Area area : {Area::kLeft, Area::kRight, Area::kBottom}) {
    const std::string label = "Move to the " + std::string(kAreaWords[static_cast<std::size_t>(area)]);
    if (ImGui::MenuItem(label.c_str())) layout.Move(panel, area);
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Close")) layout.Close(panel);
  ImGui::EndPopup();
}

void Workspace::DrawSplitter(Area area, ImVec2 corner, ImVec2 size, const Metrics& m) {
  const float grip = kGrip_px * m.scale;
  ImVec2 at = corner, extent{grip, size.y};
  if (area == Area::kLeft) at.x += size.x - grip;
  if (area == Area::kBottom) extent = {size.x, grip};
  ImGui::SetCursorScreenPos(at);
  ImGui::InvisibleButton("splitter", extent);
  const bool active = ImGui::IsItemActive();
  if (active || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(area == Area::kBottom ? ImGuiMouseCursor_ResizeNS : ImGuiMouseCursor_ResizeEW);
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + extent.x, at.y + extent.y},
                                              theme::Packed(theme::kAccent, active ? 0.8f : 0.4f));
  }
  if (!active) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float wanted = area == Area::kLeft    ? mouse.x
                       : area == Area::kRight ? m.width - mouse.x
                                              : m.height - m.scrubber - mouse.y;
  layout.at(area).size = std::clamp(wanted / (area == Area::kBottom ? m.down : m.across), 80.0f, 4000.0f);
}

}  // namespace soarbox::viewer
