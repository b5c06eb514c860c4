// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/first_steps.h"

#include <algorithm>
#include <array>

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

bool IsOfAsking(const PanelRequest& request) {
  const auto* why = std::get_if<WhyRequest>(&request);
  return why != nullptr || std::holds_alternative<RuleRequest>(request);
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
  // One at a time: who does two things at once still reads what comes between them.
  if (IsDone(seen)) ++at_;
}

StripPlace DrawFirstSteps(PanelFrame& frame, FirstSteps& steps, ImVec2 corner, ImVec2 size) {
  FirstSteps::Seen seen;
  seen.selected = frame.selected;
  seen.agents = frame.scene.agents.size();
  seen.shows_why = frame.layout.IsVisible(PanelId::kWhy);
  seen.has_asked = std::any_of(frame.requests.begin(), frame.requests.end(), IsOfAsking);
  seen.is_paused = frame.status.paused;
  seen.is_recording = frame.contents.moment.is_recording;
  seen.is_in_past = !frame.contents.moment.is_live;
  steps.Note(seen);

  const float width = std::min(frame.Px(560), size.x - frame.Px(16));
  ImGui::SetNextWindowPos({corner.x + size.x / 2, corner.y + size.y - frame.Px(8)}, ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, size.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
  ImGui::PushStyleColor(ImGuiCol_Border, theme::kAccent);
  ImGui::Begin("First steps", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoScrollbar);
  const bool is_end = steps.at() >= FirstSteps::kSteps;
  Heading(frame, "First steps");
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
  const StripPlace place{ImGui::GetWindowPos(), ImGui::GetWindowSize()};
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar();
  return place;
}

}  // namespace soarbox::viewer
