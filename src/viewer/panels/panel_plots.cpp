// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "viewer/panels/graph.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

/// Numbers over time.
class PlotsPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const PanelContents& contents = frame.contents;
    DrawBar(frame);
    if (contents.plots == nullptr || contents.plots->empty()) {
      EmptyNote("Nothing is plotted yet.",
                "Choose a number of the selected agent above: health, speed, rules fired, decision time, a percept or "
                "any number in working memory (right click it in the panel Memory).");
      return;
    }
    ImGui::BeginChild("plots", {0, 0}, false, ImGuiWindowFlags_NoNav);
    const auto count = static_cast<float>(contents.plots->size());
    const float label = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    const float height = std::clamp(ImGui::GetContentRegionAvail().y / count - label, frame.Px(44), frame.Px(160));
    std::size_t number = 0;
    for (const debugger::PlotSeries& series : *contents.plots) DrawPlot(frame, series, number++, height);
    ImGui::EndChild();
  }

 private:
  void DrawBar(PanelFrame& frame) {
    const PanelContents& contents = frame.contents;
    if (contents.agent.empty()) {
      ColoredText(theme::kQuiet, "Select an agent to plot its numbers.");
      return;
    }
    ImGui::SetNextItemWidth(std::min(frame.Px(340), ImGui::GetContentRegionAvail().x));
    if (ImGui::BeginCombo("##what", ("Plot a number of " + contents.agent).c_str(), ImGuiComboFlags_HeightLargest)) {
      SearchField("##filter", "Filter", filter_);
      for (const char* usual : {"health", "speed", "decisions", "fired", "decide_us"}) Choice(frame, usual);
      for (const std::string& path : contents.plottable) {
        if (path != "health" && path != "speed" && path != "decisions" && path != "fired" && path != "decide_us")
          Choice(frame, path);
      }
      ImGui::EndCombo();
    }
  }

  void Choice(PanelFrame& frame, const std::string& what) {
    if (!HasPart(what, filter_)) return;
    if (ImGui::Selectable(what.c_str())) frame.Ask(PlotRequest{frame.contents.agent, what, true});
  }

  static void DrawPlot(PanelFrame& frame, const debugger::PlotSeries& series, std::size_t number, float height) {
    ImGui::PushID(static_cast<int>(number));
    const ImVec4 color = theme::kSeries[number % (sizeof theme::kSeries / sizeof theme::kSeries[0])];
    GraphCurve curve{series.what, color, {}};
    curve.points.reserve(series.points.size());
    for (const debugger::PlotPoint& point : series.points)
      curve.points.emplace_back(static_cast<double>(point.tick), point.value);
    ColoredText(color, series.agent + "  " + series.what);
    if (!series.points.empty()) {
      ImGui::SameLine();
      ColoredText(theme::kText, Formatted("%.5g", series.points.back().value));
    }
    ImGui::SameLine();
    if (ImGui::SmallButton("\xc3\x97")) frame.Ask(PlotRequest{series.agent, series.what, false});
    Tooltip("No longer plot it");
    const Moment& moment = frame.contents.moment;
    const double first = series.points.empty() ? static_cast<double>(moment.first_tick)
                                               : static_cast<double>(series.points.front().tick);
    if (const auto tick =
            DrawGraph(frame, "graph", {&curve, 1}, height, first, static_cast<double>(moment.last_tick), true))
      frame.Ask(SeekRequest{*tick});
    ImGui::PopID();
  }

  std::string filter_;
};

}  // namespace

std::unique_ptr<Panel> MakePlotsPanel() {
  return std::make_unique<PlotsPanel>();
}

}  // namespace soarbox::viewer
