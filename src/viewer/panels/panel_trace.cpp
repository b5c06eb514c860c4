// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::TraceKind;
using debugger::TraceLine;

ImVec4 TraceColor(TraceKind kind) {
  switch (kind) {
    case TraceKind::kError:
      return theme::kBad;
    case TraceKind::kDecision:
      return theme::kGood;
    case TraceKind::kCommand:
      return theme::kNumber;
    case TraceKind::kEvent:
      return theme::kText;
    case TraceKind::kInput:
      return theme::kWarn;
    case TraceKind::kPercept:
      return theme::kVariable;
    case TraceKind::kRule:
      return theme::kAccent;
    case TraceKind::kElement:
      break;
  }
  return theme::kQuiet;
}

/// What happened, line by line.
class TracePanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const debugger::Trace* trace = frame.contents.trace;
    if (trace == nullptr || trace->lines().empty()) {
      EmptyNote("Nothing has happened yet.", "Let the world run: what minds decide and say appears here.");
      return;
    }
    DrawBar(frame);
    filter_.agent = only_selected_ ? frame.contents.agent : std::string{};
    const auto& found = search_.Find(*trace, filter_);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::kField);
    const Part lines("lines", {0, 0}, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::PopStyleColor();
    const FontScope mono(frame.fonts.mono);
    const bool at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 2;
    ForRowsInSight(
        found.size(), [&](int i) { DrawLine(frame, *found[static_cast<std::size_t>(i)], i); },
        ImGui::GetTextLineHeightWithSpacing());
    if (at_end && frame.contents.moment.is_live) ImGui::SetScrollHereY(1);
  }

  std::string Text(const PanelFrame& frame) const override {
    const debugger::Trace* trace = frame.contents.trace;
    return trace == nullptr ? std::string() : debugger::ToText(trace->Find(filter_));
  }

 private:
  void DrawBar(PanelFrame& frame) {
    const char* kLevels[] = {"errors", "decisions", "commands", "events", "input", "percepts", "rules", "elements"};
    // Where lines have little room, all of this stands in one row.
    constexpr float kNarrow = 330;
    const bool is_narrow = ImGui::GetContentRegionAvail().x < frame.Px(kNarrow);
    ImGui::SetNextItemWidth(frame.Px(is_narrow ? 98 : 110));
    int level = static_cast<int>(filter_.most);
    if (ImGui::Combo("##level", &level, kLevels, IM_ARRAYSIZE(kLevels))) filter_.most = static_cast<TraceKind>(level);
    Tooltip(
        "How much to show: each level includes those above it. Rules and elements are noted for the selected agent.");
    if (is_narrow) {
      ImGui::SameLine(0, frame.Px(4));
      if (ImGui::BeginCombo("##about", nullptr, ImGuiComboFlags_NoPreview)) {
        ImGui::Checkbox("selected agent", &only_selected_);
        ImGui::Separator();
        DrawChoices(frame);
        ImGui::EndCombo();
      }
      Tooltip("Only lines about the selected agent, a rule, an operator, a command or an attribute");
      ImGui::SameLine(0, frame.Px(4));
      DrawSearch(only_selected_ ? "Search the agent's" : "Search");
      return;
    }
    FlowLine(frame.Px(110), frame.Px(4));
    ImGui::SetNextItemWidth(frame.Px(110));
    if (ImGui::BeginCombo("##about", "Only ...")) {
      DrawChoices(frame);
      ImGui::EndCombo();
    }
    Tooltip("Only lines about a rule, an operator, a command or an attribute");
    const float box = ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x;
    FlowLine(box + ImGui::CalcTextSize("selected agent").x, frame.Px(6));
    ImGui::Checkbox("selected agent", &only_selected_);
    FlowLine(frame.Px(150), frame.Px(6));
    DrawSearch("Search; rule:NAME op:NAME ^attribute");
  }

  void DrawSearch(const char* hint) {
    SearchField("##search", hint, filter_.text);
    Tooltip(
        "The line must contain each word. rule:NAME, op:NAME, command:NAME and ^attribute show lines about these "
        "alone.");
  }

  /// What lines may be about: what is known of the selected agent.
  void DrawChoices(PanelFrame& frame) {
    if (ImGui::Selectable("everything")) filter_.text.clear();
    const auto offer = [&](const std::string& word) {
      if (ImGui::Selectable(word.c_str())) filter_.text = word;
    };
    constexpr std::size_t kMost = 12, kLookAt = 300;
    std::vector<std::string> seen;
    const auto once = [&](const std::string& word) {
      if (seen.size() < kMost && std::find(seen.begin(), seen.end(), word) == seen.end()) seen.push_back(word);
    };
    const debugger::TimelineTrack* track =
        frame.contents.timeline == nullptr ? nullptr : frame.contents.timeline->Find(frame.contents.agent);
    if (track != nullptr) {
      std::size_t looked = 0;
      for (auto span = track->spans.rbegin(); span != track->spans.rend() && ++looked < kLookAt; ++span)
        if (!span->is_state && !span->text.empty()) once("op:" + span->text);
    }
    for (const std::string& word : seen) offer(word);
    seen.clear();
    for (const debugger::AgentRow& row : frame.contents.agents)
      if (!row.command.empty()) once("command:" + row.command);
    for (const std::string& word : seen) offer(word);
    ImGui::Separator();
    // Rules and attributes are many: what is typed behind them narrows them down.
    offer("rule:");
    offer("op:");
    offer("^");
  }

  static void DrawLine(PanelFrame& frame, const TraceLine& line, int number) {
    const bool is_now = line.tick == frame.contents.moment.shown_tick;
    const IdScope id(number);
    TimeLink(frame, line.tick,
             "Click to go to tick " + std::to_string(line.tick) + "; so does a double click on the line",
             is_now ? theme::kWarn : theme::kQuiet);
    ImGui::SameLine();
    ColoredText(theme::kQuiet, line.agent.empty() ? "world" : line.agent);
    ImGui::SameLine();
    const std::string text = std::string(static_cast<std::size_t>(std::max(0, line.level - 1)) * 2, ' ') + line.text;
    if (line.kind == TraceKind::kError) {
      TextWithPlace(frame, "place", text, TraceColor(line.kind));
    } else {
      ColoredText(TraceColor(line.kind), text);
      if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) frame.Ask(workbench::SeekRequest{line.tick});
    }
  }

  debugger::TraceFilter filter_;
  bool only_selected_ = false;
  debugger::TraceSearch search_;
};

}  // namespace

std::unique_ptr<Panel> MakeTracePanel() {
  return std::make_unique<TracePanel>();
}

}  // namespace soarbox::viewer
