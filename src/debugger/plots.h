// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "debugger/recorded_mind.h"
#include "record/percept_values.h"
#include "record/tick_record.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

struct PlotPoint {
  std::uint64_t tick = 0;
  double value = 0;
};

/// One number of an agent over ticks.
struct PlotSeries {
  std::string agent;
  std::string what;  ///< See Plots.
  std::deque<PlotPoint> points;
  double minimum = 0, maximum = 0;  ///< Of the points.
  bool has_firings = false;         ///< Of "fired": firings were noted, so that none means none.
};

/// Numbers over ticks. What can be plotted of an agent:
///   "health", "speed", "fired" (rules that fired, MindDetail::kAll), "decisions",
///   "decide_us" (real time), "reward" (in all), "learned:RULE" (the rule's number): all three only of a live run,
///   a percept's path ("self.speed", "agent#3.range"),
///   a way through working memory from an identifier ("S1.reward-link.reward.value"; only of a live run).
class Plots {
 public:
  /// Begins with what is known of it; false if it is there already.
  bool Plot(std::string agent, std::string what);
  bool Remove(std::string_view agent, std::string_view what);
  void Clear() { series_.clear(); }

  /// What a tick's record tells. Ticks come in order; an earlier one takes back the points from there on.
  void Add(const record::TickRecord& tick);
  /// Puts earlier points (see PlotHistory) in front of a plot's first.
  void Prepend(std::string_view agent, std::string_view what, const std::vector<PlotPoint>& points);
  /// What only the live run tells: call after Add of the same tick.
  void Sample(const sim::Simulation& simulation);

  const std::vector<PlotSeries>& series() const { return series_; }

  /// Of a plot, and of the decision times that are noted of every agent. When there are more, the older half is thinned
  /// out: of four points that follow each other the least and the greatest stay, so that a plot keeps its beginning.
  static constexpr std::size_t kMostPoints = 20'000, kMostTimes = 4'000;

 private:
  void Point(PlotSeries& series, std::uint64_t tick, double value);

  std::vector<PlotSeries> series_;
  std::map<std::string, record::PerceptValues, std::less<>> percepts_;  ///< By agent.
  /// By agent, noted always: nobody can tell them later.
  std::map<std::string, std::deque<PlotPoint>, std::less<>> times_;
};

/// One number of an agent in ticks that are over, for a plot that begins after them. Decision times are not among what
/// is recorded of a tick; a way through working memory is followed where its elements were noted.
class PlotHistory {
 public:
  PlotHistory(std::string agent, std::string what);

  const std::string& agent() const { return agent_; }
  const std::string& what() const { return what_; }
  /// Ticks in order.
  void Add(const record::TickRecord& tick);
  const std::vector<PlotPoint>& points() const { return points_; }

 private:
  std::string agent_, what_;
  bool is_memory_, has_firings_ = false;
  std::map<std::string, record::PerceptValues, std::less<>> percepts_;
  RecordedMinds mind_;
  std::vector<PlotPoint> points_;
};

/// What is measured and its unit: "decision time (µs)", "self.position.x (m)".
std::string PlotTitle(std::string_view what);

/// Paths that can be plotted of an agent now: what is always there, numbers among its percepts, numbers of its states.
std::vector<std::string> Plottable(explain::Inspector& mind);

std::string ToText(const std::vector<PlotSeries>& series);
Json ToJson(const std::vector<PlotSeries>& series);

}  // namespace soarbox::debugger
