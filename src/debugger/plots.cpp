// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "debugger/learning_log.h"
#include "debugger/percept_help.h"
#include "diagnostics/number_from_chars.h"
#include "explain/learning_facts.h"
#include "explain/rule_text.h"
#include "wording/mind_words.h"

namespace soarbox::debugger {
namespace {

std::optional<double> Number(std::string_view text) {
  double value = 0;
  const auto read = NumberFromChars(text, value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool IsMemoryPath(std::string_view what) {
  const std::size_t dot = what.find('.');
  return dot != std::string_view::npos && explain::IsIdentifier(what.substr(0, dot));
}

constexpr std::string_view kLearned = "learned:";

bool IsLearning(std::string_view what) {
  return what == "reward" || what.starts_with(kLearned);
}

/// The total reward, or the learned value of a rule.
std::optional<double> Learned(explain::Inspector& mind, std::string_view what) {
  auto* const source = dynamic_cast<explain::LearningSource*>(&mind);
  if (source == nullptr) return std::nullopt;
  const explain::LearningFacts facts = source->Learning();
  if (what == "reward") return facts.total_reward;
  const auto number = std::ranges::find(facts.numbers, what.substr(kLearned.size()), &explain::NumberFact::rule);
  if (number == facts.numbers.end()) return std::nullopt;
  return number->value;
}

/// The first number at the end of a path like "S1.io.input-link.speed".
std::optional<double> Follow(explain::Inspector& mind, std::string_view path) {
  std::size_t dot = path.find('.');
  std::string id(path.substr(0, dot));
  while (dot != std::string_view::npos) {
    path.remove_prefix(dot + 1);
    dot = path.find('.');
    const std::string_view attribute = path.substr(0, dot);
    const std::vector<explain::ElementFact> elements = mind.ElementsOf(id);
    const auto at = std::ranges::find_if(
        elements, [&](const explain::ElementFact& e) { return e.attribute == attribute && !e.acceptable; });
    if (at == elements.end()) return std::nullopt;
    if (dot == std::string_view::npos) return Number(at->value);
    id = at->value;
  }
  return std::nullopt;
}

std::optional<double> OfBody(const record::TickRecord& tick, std::string_view agent, std::string_view what) {
  const auto at = std::ranges::find(tick.scene.agents, agent, &world::AgentSnapshot::name);
  if (at == tick.scene.agents.end()) return std::nullopt;
  return what == "health" ? at->health : world::Length(at->velocity);
}

/// A path in working memory, and the corresponding path of a percept if no attribute on it occurs twice.
struct PathNames {
  std::string memory;
  std::optional<std::string> percept;
};

void NumbersBelow(explain::Inspector& mind, const std::string& id, const PathNames& path, int depth,
                  std::vector<std::string>& paths) {
  constexpr std::size_t kMostPaths = 500;
  const std::vector<explain::ElementFact> elements = mind.ElementsOf(id);
  for (const explain::ElementFact& element : elements) {
    if (paths.size() >= kMostPaths) return;
    PathNames name{path.memory + "." + element.attribute, std::nullopt};
    const bool is_alone = std::ranges::count(elements, element.attribute, &explain::ElementFact::attribute) == 1;
    if (path.percept && is_alone)
      name.percept = path.percept->empty() ? element.attribute : *path.percept + "." + element.attribute;
    const std::string& shown = name.percept ? *name.percept : name.memory;
    if (element.is_object) {
      if (depth > 1) NumbersBelow(mind, element.value, name, depth - 1, paths);
    } else if (Number(element.value) && std::ranges::find(paths, shown) == paths.end()) {
      paths.push_back(shown);
    }
  }
}

/// The value in the record of a tick. `percepts` are those of the agent at the end of the tick.
std::optional<double> ValueIn(const record::TickRecord& tick, std::string_view agent, std::string_view what,
                              const std::map<std::string, record::PerceptValues, std::less<>>& percepts,
                              bool& has_firings) {
  const record::MindRecord* mind = record::FindMind(tick, agent);
  if (what == "health" || what == "speed") return OfBody(tick, agent, what);
  if (what == "decisions" || what == "fired") {
    double decided = 0, fired = 0;
    mind::Event event;
    for (std::size_t at = 0; mind != nullptr && mind->events.Next(at, event);) {
      has_firings |= mind::IsDetail(event);
      const auto* firing = std::get_if<mind::RuleFired>(&event);
      fired += firing != nullptr && !firing->retracts ? 1 : 0;
      decided += !wording::DecisionLine(event).empty() && !wording::IsOfReward(event) ? 1 : 0;
    }
    if (what == "fired" && !has_firings) return std::nullopt;
    return what == "fired" ? fired : decided;
  }
  const auto known = percepts.find(agent);
  if (known == percepts.end()) return std::nullopt;
  const auto percept = known->second.find(what);
  if (percept == known->second.end()) return std::nullopt;
  return std::visit(mind::Cases{[](const std::string& word) { return Number(word); },
                                [](auto number) { return std::optional(static_cast<double>(number)); }},
                    percept->second);
}

/// Reduces the older half of the points if there are more than `most` (Plots::kMostPoints).
void ThinOut(std::deque<PlotPoint>& points, std::size_t most) {
  if (points.size() <= most) return;
  constexpr std::size_t kGroup = 4;
  const std::size_t half = most / 2 / kGroup * kGroup;
  std::deque<PlotPoint> thin;
  for (std::size_t i = 0; i < half; i += kGroup) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(i);
    const auto [least, greatest] = std::minmax_element(
        begin, begin + kGroup, [](const PlotPoint& a, const PlotPoint& b) { return a.value < b.value; });
    thin.push_back(*std::min(least, greatest));
    if (least != greatest) thin.push_back(*std::max(least, greatest));
  }
  thin.insert(thin.end(), points.begin() + static_cast<std::ptrdiff_t>(half), points.end());
  points.swap(thin);
}

}  // namespace

bool Plots::Plot(std::string agent, std::string what) {
  const bool is_there = std::ranges::any_of(
      series_, [&](const PlotSeries& series) { return series.agent == agent && series.what == what; });
  if (is_there) return false;
  PlotSeries& series = series_.emplace_back();
  series.agent = std::move(agent);
  series.what = std::move(what);
  if (series.what != "decide_us") return true;
  if (const auto times = times_.find(series.agent); times != times_.end())
    for (const PlotPoint& point : times->second) Point(series, point.tick, point.value);
  return true;
}

bool Plots::Remove(std::string_view agent, std::string_view what) {
  return std::erase_if(series_,
                       [&](const PlotSeries& series) { return series.agent == agent && series.what == what; }) != 0;
}

void Plots::Point(PlotSeries& series, std::uint64_t tick, double value) {
  series.points.push_back({tick, value});
  ThinOut(series.points, kMostPoints);
  const bool is_first = series.points.size() == 1;
  series.minimum = is_first ? value : std::min(series.minimum, value);
  series.maximum = is_first ? value : std::max(series.maximum, value);
}

void Plots::Prepend(std::string_view agent, std::string_view what, const std::vector<PlotPoint>& points) {
  const auto series =
      std::ranges::find_if(series_, [&](const PlotSeries& one) { return one.agent == agent && one.what == what; });
  if (series == series_.end()) return;  // The plot was removed in the meantime.
  std::deque<PlotPoint> later;
  later.swap(series->points);
  for (const PlotPoint& point : points)
    if (later.empty() || point.tick < later.front().tick) Point(*series, point.tick, point.value);
  for (const PlotPoint& point : later) Point(*series, point.tick, point.value);
}

void Plots::Add(const record::TickRecord& tick) {
  for (const record::MindRecord& mind : tick.minds) record::ApplyPercepts(mind.events, percepts_[mind.agent]);
  for (PlotSeries& series : series_) {
    while (!series.points.empty() && series.points.back().tick >= tick.tick) series.points.pop_back();
    const std::optional<double> value = ValueIn(tick, series.agent, series.what, percepts_, series.has_firings);
    if (value) Point(series, tick.tick, *value);
  }
}

void Plots::Sample(const sim::Simulation& simulation) {
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const sim::MindReport report = simulation.Mind(i);
    std::deque<PlotPoint>& times = times_[report.agent];
    while (!times.empty() && times.back().tick >= simulation.tick()) times.pop_back();
    times.push_back({simulation.tick(), report.decide_s * 1e6});
    ThinOut(times, kMostTimes);
  }
  for (PlotSeries& series : series_) {
    if (series.what == "decide_us") {
      const auto times = times_.find(series.agent);
      if (times != times_.end() && times->second.back().tick == simulation.tick())
        Point(series, simulation.tick(), times->second.back().value);
    } else if (IsMemoryPath(series.what) || IsLearning(series.what)) {
      const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(series.agent);
      if (mind == nullptr) continue;
      const std::optional<double> value =
          IsLearning(series.what) ? Learned(*mind, series.what) : Follow(*mind, series.what);
      if (value) Point(series, simulation.tick(), *value);
    }
  }
}

PlotHistory::PlotHistory(std::string agent, std::string what)
    : agent_(std::move(agent)),
      what_(std::move(what)),
      is_memory_(IsMemoryPath(what_)),
      mind_(record::Level::kAll, agent_) {}

void PlotHistory::Add(const record::TickRecord& tick) {
  std::optional<double> value;
  if (is_memory_) {
    mind_.Add(tick);
    if (const std::unique_ptr<explain::Inspector> mind = mind_.Inspect(agent_)) value = Follow(*mind, what_);
  } else {
    if (const record::MindRecord* mind = record::FindMind(tick, agent_))
      record::ApplyPercepts(mind->events, percepts_[agent_]);
    value = ValueIn(tick, agent_, what_, percepts_, has_firings_);
  }
  if (value) points_.push_back({tick.tick, *value});
}

std::string PlotTitle(std::string_view what) {
  if (what == "speed") return "speed (m/s)";
  if (what == "decisions") return "decisions per tick";
  if (what == "fired") return "rules fired per tick";
  if (what == "decide_us") return "decision time (\xc2\xb5s)";
  std::string title(what);
  const vocabulary::PerceptRow* row = PerceptOf(what);
  if (row != nullptr && !row->unit.empty()) title.append(" (").append(row->unit).append(")");
  return title;
}

std::vector<std::string> Plottable(explain::Inspector& mind) {
  std::vector<std::string> paths = {"health", "speed", "decisions", "fired", "decide_us"};
  const explain::MindFacts facts = mind.Mind();
  constexpr int kDepth = 4;
  if (!facts.input_link.empty()) NumbersBelow(mind, facts.input_link, {facts.input_link, std::string()}, kDepth, paths);
  for (const explain::StateFact& state : mind.Stack())
    for (const explain::ElementFact& element : mind.ElementsOf(state.id))
      if (!element.is_object && Number(element.value)) paths.push_back(state.id + "." + element.attribute);
  constexpr std::size_t kMostNumbers = 200;
  if (auto* const source = dynamic_cast<explain::LearningSource*>(&mind)) {
    const explain::LearningFacts learning = source->Learning();
    if (!learning.numbers.empty()) paths.push_back("reward");
    for (std::size_t n = 0; n < std::min(learning.numbers.size(), kMostNumbers); ++n) {
      paths.push_back(std::string(kLearned) + learning.numbers[n].rule);
    }
  }
  return paths;
}

std::string ToText(const std::vector<PlotSeries>& series) {
  std::string text;
  for (const PlotSeries& one : series) {
    text += fmt::format("{} {}: {} points, {:g} to {:g}\n", one.agent, one.what, one.points.size(), one.minimum,
                        one.maximum);
    for (const PlotPoint& point : one.points) text += fmt::format("  {:>6} {:g}\n", point.tick, point.value);
  }
  return series.empty() ? "nothing is plotted\n" : text;
}

}  // namespace soarbox::debugger
