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
    const workbench::Contents& contents = frame.contents;
    DrawBar(frame);
    if (contents.plots == nullptr || contents.plots->empty()) {
      EmptyNote("Nothing is plotted yet.",
                "Choose a number of the selected agent above: health, speed, rules fired, decision time, a percept or "
                "any number in working memory (right click it in the panel Memory).");
      return;
    }
    const Part part("plots");
    const auto count = static_cast<float>(contents.plots->size());
    const float label = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    const float room = ImGui::GetContentRegionAvail().y - TimeAxisHeight() - ImGui::GetStyle().ItemSpacing.y;
    const float height = std::clamp(room / count - label, frame.Px(44), frame.Px(160));
    // All of them over the same time, so that what stands above each other happened together.
    const workbench::Moment& moment = contents.moment;
    double first = static_cast<double>(moment.last_tick);
    for (const debugger::PlotSeries& series : *contents.plots) {
      first =
          std::min(first, static_cast<double>(series.points.empty() ? moment.first_tick : series.points.front().tick));
    }
    std::size_t number = 0;
    for (const debugger::PlotSeries& series : *contents.plots) DrawPlot(frame, series, number++, height, first);
    DrawTimeAxis(frame, first, static_cast<double>(moment.last_tick));
  }

  std::string Text(const PanelFrame& frame) const override {
    const auto* plots = frame.contents.plots;
    return plots == nullptr || plots->empty() ? std::string() : debugger::ToText(*plots);
  }

 private:
  void DrawBar(PanelFrame& frame) {
    const workbench::Contents& contents = frame.contents;
    if (contents.agent.empty()) {
      ColoredText(theme::kQuiet, "Select an agent to plot its numbers.");
      return;
    }
    ImGui::SetNextItemWidth(std::min(frame.Px(340), ImGui::GetContentRegionAvail().x));
    if (ImGui::BeginCombo("##what", ("Plot a number of " + contents.agent).c_str(), ImGuiComboFlags_HeightLargest)) {
      SearchField("##filter", "Filter", filter_);
      constexpr std::string_view kUsual[] = {"health", "speed", "decisions", "fired", "decide_us"};
      for (const std::string_view usual : kUsual) Choice(frame, std::string(usual));
      for (const std::string& path : contents.plottable) {
        if (std::ranges::find(kUsual, path) == std::end(kUsual)) Choice(frame, path);
      }
      ImGui::EndCombo();
    }
  }

  void Choice(PanelFrame& frame, const std::string& what) {
    if (!HasPart(debugger::PlotTitle(what), filter_)) return;
    if (ImGui::Selectable((debugger::PlotTitle(what) + "##" + what).c_str()))
      frame.Ask(workbench::PlotRequest{frame.contents.agent, what, true});
  }

  /// Why a plot has no points, or where they begin.
  static std::string NoteOf(const debugger::PlotSeries& series, const workbench::Moment& moment) {
    if (series.points.empty()) {
      if (series.what == "decide_us" && moment.is_recording) return "not recorded: it is only measured during a run";
      if (series.what == "fired") {
        return moment.is_recording ? "not recorded at this level: it takes --record-level all"
                                   : "noted while the agent is selected, from the next tick on";
      }
      return "no value yet";
    }
    return {};
  }

  static void DrawPlot(PanelFrame& frame, const debugger::PlotSeries& series, std::size_t number, float height,
                       double first) {
    const IdScope id(static_cast<int>(number));
    const ImVec4 color = theme::Series(number);
    GraphCurve curve{debugger::PlotTitle(series.what), color, {}};
    curve.points.reserve(series.points.size());
    for (const debugger::PlotPoint& point : series.points)
      curve.points.emplace_back(static_cast<double>(point.tick), point.value);
    // The value and the button keep their places at the right, whatever the name's length.
    std::string value = NoteOf(series, frame.contents.moment);
    if (!series.points.empty()) value = Formatted("%.5g", series.points.back().value);
    const float gap = ImGui::GetStyle().ItemSpacing.x, button = ButtonWidth("\xc3\x97") + gap;
    const float room = ImGui::GetContentRegionAvail().x - button - gap;
    const std::string title = series.agent + "  " + debugger::PlotTitle(series.what);
    CutText(title, std::max(room * 0.5f, room - ImGui::CalcTextSize(value.c_str()).x - gap), color);
    ImGui::SameLine();
    CutText(value, ImGui::GetContentRegionAvail().x - button, series.points.empty() ? theme::kQuiet : theme::kText);
    ImGui::SameLine();
    if (ImGui::SmallButton("\xc3\x97")) frame.Ask(workbench::PlotRequest{series.agent, series.what, false});
    Tooltip("No longer plot it");
    const workbench::Moment& moment = frame.contents.moment;
    DrawGraph(frame, "graph", {&curve, 1}, height, first, static_cast<double>(moment.last_tick), true);
  }

  std::string filter_;
};

}  // namespace

std::unique_ptr<Panel> MakePlotsPanel() {
  return std::make_unique<PlotsPanel>();
}

}  // namespace soarbox::viewer
