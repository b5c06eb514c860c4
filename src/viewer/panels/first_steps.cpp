// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/first_steps.h"

#include <algorithm>
#include <array>
#include <string>

#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

enum Step : std::size_t { kSelect, kOpenWhy, kAsk, kPause, kGoBack };

constexpr std::array<std::string_view, FirstSteps::kSteps + 1> kTexts{
    "Click an agent in the picture or in the list on the left. All panels then show that agent.",
    "Open the Why tab on the right. It explains why the agent does what it does.",
    "Click a line of the answer to ask further. Or type what the agent does not do, such as \"flee\", and press Enter.",
    "Press P to pause the world, N to advance it by one tick, and P again to continue.",
    "Drag the bar at the bottom to any earlier moment. Live brings you back.",
    "That is how you find out why. Hold the mouse over a word to see what it means. Press ? for all keys.",
};

constexpr const char* kTitle = "First steps";

bool IsOfAsking(const workbench::Request& request) {
  const auto* why = std::get_if<workbench::WhyRequest>(&request);
  return why != nullptr || std::holds_alternative<workbench::RuleRequest>(request);
}

}  // namespace

std::string_view FirstSteps::text() const {
  return kTexts[std::min(at_, kSteps)];
}

bool FirstSteps::IsDone(const Seen& seen) const {
  switch (at_) {
    case kSelect:
      return seen.agents < 2 || (seen.selected != 0 && seen.selected != *first_selected_);
    case kOpenWhy:
      return seen.shows_why;
    case kAsk:
      return seen.has_asked;
    case kPause:
      return seen.is_paused;
    case kGoBack:
      return seen.is_in_past || seen.is_recording;
    default:
      return false;
  }
}

void FirstSteps::Note(const Seen& seen) {
  if (seen.agents == 0) return;
  if (!first_selected_) first_selected_ = seen.selected;
  // Advances by one step at a time, so that the user can read each text.
  if (IsDone(seen)) ++at_;
}

ScreenBox PlaceOfStrip(const ScreenBox& area, float width, const std::function<float(float)>& height_of,
                       std::span<const ScreenBox> not_over) {
  constexpr float kNarrowest = 0.45f;
  enum class Side : std::uint8_t { kMiddle, kLeft, kRight };
  const auto place = [&](Side side, bool is_low, float wide) {
    const float high = height_of(wide), free = area.width() - wide;
    const float left = area.left + (side == Side::kMiddle ? free / 2 : side == Side::kLeft ? 0 : free);
    const float top = is_low ? area.bottom - high : area.top;
    return ScreenBox{left, top, left + wide, top + high};
  };
  for (const bool is_low : {true, false}) {
    for (float wide = width; wide >= kNarrowest * width; wide -= 0.05f * width) {
      for (const Side side : {Side::kMiddle, Side::kLeft, Side::kRight}) {
        const ScreenBox box = place(side, is_low, wide);
        if (std::ranges::none_of(not_over, [&](const ScreenBox& other) { return Meet(box, other); })) return box;
      }
    }
  }
  return place(Side::kMiddle, true, width);
}

ScreenBox DrawFirstSteps(PanelFrame& frame, FirstSteps& steps, const ScreenBox& area,
                         std::span<const ScreenBox> not_over) {
  FirstSteps::Seen seen;
  seen.selected = frame.selected;
  seen.agents = frame.scene.agents.size();
  seen.shows_why = frame.layout.IsVisible(workbench::PanelId::kWhy);
  seen.has_asked = std::any_of(frame.requests.begin(), frame.requests.end(), IsOfAsking);
  seen.is_paused = frame.status.paused;
  seen.is_recording = frame.contents.moment.is_recording;
  seen.is_in_past = !frame.contents.moment.is_live;
  steps.Note(seen);

  const float edge = frame.Px(8);
  const ScreenBox inner{area.left + edge, area.top + edge, area.right - edge, area.bottom - edge};
  const float width = std::min(frame.Px(560), inner.width());
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto height_of = [&](float wide) {
    const std::string text(steps.text());
    return 2 * style.WindowPadding.y + ImGui::GetTextLineHeight() + style.ItemSpacing.y +
           ImGui::CalcTextSize(text.c_str(), nullptr, false, wide - 2 * style.WindowPadding.x).y;
  };
  const ScreenBox place = PlaceOfStrip(inner, width, height_of, not_over);
  const bool is_low = place.bottom >= inner.bottom;
  ImGui::SetNextWindowPos({place.left, is_low ? place.bottom : place.top}, ImGuiCond_Always, {0, is_low ? 1.0f : 0.0f});
  ImGui::SetNextWindowSizeConstraints({place.width(), 0}, {place.width(), area.height()});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
  ImGui::PushStyleColor(ImGuiCol_Border, theme::kAccent);
  BeginOver(kTitle, nullptr,
            ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                ImGuiWindowFlags_NoScrollbar);
  const bool is_end = steps.at() >= FirstSteps::kSteps;
  Heading(frame, kTitle);
  if (!is_end) {
    ImGui::SameLine();
    ColoredText(theme::kQuiet, std::to_string(steps.at() + 1) + " of " + std::to_string(FirstSteps::kSteps));
  }
  const float buttons = ButtonWidth("Close") + (is_end ? 0 : ButtonWidth("Skip") + ImGui::GetStyle().ItemSpacing.x);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - buttons);
  if (!is_end) {
    if (ImGui::SmallButton("Skip")) steps.Skip();
    Tooltip("To the next step");
    ImGui::SameLine();
  }
  if (ImGui::SmallButton("Close")) frame.layout.first_steps = false;
  Tooltip("Not shown again; Help > First steps brings it back");
  WrappedText(steps.text());
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  return {corner.x, corner.y, corner.x + size.x, corner.y + size.y};
}

}  // namespace soarbox::viewer
