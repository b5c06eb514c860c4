// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/recorded_mind.h"
#include "record/percept_values.h"
#include "record/tick_record.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

struct PlotPoint {
  std::uint64_t tick = 0;
  double value = 0;
};

/// One quantity of an agent over time.
struct PlotSeries {
  std::string agent;
  std::string what;  ///< See Plots.
  std::deque<PlotPoint> points;
  double minimum = 0, maximum = 0;  ///< Of the points.
  bool has_firings = false;         ///< For "fired": firings are recorded, so that no point means that no rule fired.
};

/// Quantities over time. These can be plotted for an agent:
///   "health", "speed", "fired" (number of rules that fired, needs MindDetail::kAll), "decisions",
///   "decide_us" (real time of its decisions in µs), "reward" (total) and "learned:RULE" (the rule's value): only live,
///   a percept's path ("self.speed", "agent#3.range"),
///   a path in working memory from an identifier ("S1.reward-link.reward.value"): only live.
class Plots {
 public:
  /// Adds a plot, which begins with the values that are already known. Returns false if the plot exists.
  bool Plot(std::string agent, std::string what);
  bool Remove(std::string_view agent, std::string_view what);
  void Clear() { series_.clear(); }

  /// Adds the values that a tick's record contains. Ticks come in order. Adding an earlier tick removes the points from
  /// that tick on.
  void Add(const record::TickRecord& tick);
  /// Inserts earlier points (see PlotHistory) before the first point of a plot.
  void Prepend(std::string_view agent, std::string_view what, const std::vector<PlotPoint>& points);
  /// Adds the values that only a live run provides. Call it after Add of the same tick.
  void Sample(const sim::Simulation& simulation);

  const std::vector<PlotSeries>& series() const { return series_; }

  /// Maximum number of points of a plot, and of decision times for each agent. Above it, the older half is thinned out:
  /// of four consecutive points the smallest and the largest stay, so that a plot keeps its beginning.
  static constexpr std::size_t kMostPoints = 20'000, kMostTimes = 4'000;

 private:
  void Point(PlotSeries& series, std::uint64_t tick, double value);

  std::vector<PlotSeries> series_;
  std::map<std::string, record::PerceptValues, std::less<>> percepts_;  ///< By agent.
  /// By agent. Always recorded, because decision times cannot be determined later.
  std::map<std::string, std::deque<PlotPoint>, std::less<>> times_;
};

/// One quantity of an agent in past ticks, for a plot that was added later. Records of ticks contain no decision times.
/// A path in working memory is followed if the elements were recorded.
class PlotHistory {
 public:
  PlotHistory(std::string agent, std::string what);

  const std::string& agent() const { return agent_; }
  const std::string& what() const { return what_; }
  /// Ticks come in order.
  void Add(const record::TickRecord& tick);
  const std::vector<PlotPoint>& points() const { return points_; }

 private:
  std::string agent_, what_;
  bool is_memory_, has_firings_ = false;
  std::map<std::string, record::PerceptValues, std::less<>> percepts_;
  RecordedMinds mind_;
  std::vector<PlotPoint> points_;
};

/// The quantity with its unit: "decision time (µs)", "self.position.x (m)".
std::string PlotTitle(std::string_view what);

/// What can be plotted for an agent now: the quantities that every agent has, its numeric percepts, and numbers of its
/// states.
std::vector<std::string> Plottable(explain::Inspector& mind);

std::string ToText(const std::vector<PlotSeries>& series);

}  // namespace soarbox::debugger
