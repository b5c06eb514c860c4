// SPDX-License-Identifier: BSD-2-Clause
// Plots: numbers of agents over time.
#include <algorithm>
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/curves.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

/// Why a plot has no points.
std::string NoteOf(const debugger::PlotSeries& series, const Moment& moment) {
  if (series.what == "decide_us" && moment.is_recording) return "not recorded: it is only measured during a run";
  if (series.what != "fired") return "no value yet";
  return moment.is_recording ? "not recorded at this level: it takes --record-level all"
                             : "noted while the agent is selected, from the next tick on";
}

Plot PlotOf(const debugger::PlotSeries& series, const Moment& moment) {
  Plot plot;
  plot.key = series.agent + "/" + series.what;
  plot.title = series.agent + "  " + debugger::PlotTitle(series.what);
  plot.is_stepped = true;
  plot.value = series.points.empty() ? NoteOf(series, moment) : Rounded(series.points.back().value, 5);
  if (!series.points.empty()) plot.range = Rounded(series.minimum) + " to " + Rounded(series.maximum);
  Curve curve{debugger::PlotTitle(series.what)};
  for (const debugger::PlotPoint& point : series.points)
    curve.points.emplace_back(static_cast<double>(point.tick), point.value);
  curve.points = Thinned(std::move(curve.points));
  plot.curves.push_back(std::move(curve));
  plot.button = Button{"\xc3\x97", Action{PlotRequest{series.agent, series.what, false}}, "No longer plot it"};
  return plot;
}

}  // namespace

Nodes PlotsDocument(const Contents& contents) {
  Nodes nodes;
  if (!contents.agent.empty()) {
    Field what{Field::Kind::kSuggested, "what", "Plot a number of " + contents.agent,
               "Plot a number of " + contents.agent};
    constexpr std::string_view kUsual[] = {"health", "speed", "decisions", "fired", "decide_us"};
    for (const std::string_view usual : kUsual) what.options.emplace_back(usual, debugger::PlotTitle(usual));
    for (const std::string& path : contents.plottable)
      if (std::ranges::find(kUsual, path) == std::end(kUsual))
        what.options.emplace_back(path, debugger::PlotTitle(path));
    nodes.push_back(LineForm("plot", PlotRequest{contents.agent, {}, true}, std::move(what), "Plot"));
  }
  if (contents.plots == nullptr || contents.plots->empty()) {
    nodes.push_back(Empty("Nothing is plotted yet.",
                          contents.agent.empty()
                              ? "Select an agent, and choose a number that is drawn over time."
                              : "Choose a number of the selected agent above: health, speed, rules fired, decision "
                                "time, a percept or any number in working memory (click it in the panel Memory)."));
    return nodes;
  }
  for (const debugger::PlotSeries& series : *contents.plots) nodes.push_back(PlotOf(series, contents.moment));
  return nodes;
}

}  // namespace soarbox::workbench::document
