// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace soarbox::debugger {
namespace {

std::optional<double> Number(std::string_view text) {
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool IsIdentifier(std::string_view text) {
  return text.size() > 1 && text[0] >= 'A' && text[0] <= 'Z' &&
         text.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

bool IsMemoryPath(std::string_view what) {
  const std::size_t dot = what.find('.');
  return dot != std::string_view::npos && IsIdentifier(what.substr(0, dot));
}

/// The first number at the end of a way like "S1.io.input-link.speed".
std::optional<double> Follow(sim::Inspector& mind, std::string_view path) {
  std::size_t dot = path.find('.');
  std::string id(path.substr(0, dot));
  while (dot != std::string_view::npos) {
    path.remove_prefix(dot + 1);
    dot = path.find('.');
    const std::string_view attribute = path.substr(0, dot);
    const std::vector<sim::ElementFact> elements = mind.ElementsOf(id);
    const auto at = std::ranges::find_if(
        elements, [&](const sim::ElementFact& e) { return e.attribute == attribute && !e.acceptable; });
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

void NumbersBelow(sim::Inspector& mind, const std::string& id, const std::string& path, int depth,
                  std::vector<std::string>& paths) {
  constexpr std::size_t kMostPaths = 500;
  for (const sim::ElementFact& element : mind.ElementsOf(id)) {
    if (paths.size() >= kMostPaths) return;
    const std::string name = path + "." + element.attribute;
    if (element.is_object) {
      if (depth > 1) NumbersBelow(mind, element.value, name, depth - 1, paths);
    } else if (Number(element.value) && std::ranges::find(paths, name) == paths.end()) {
      paths.push_back(name);
    }
  }
}

}  // namespace

bool Plots::Plot(std::string agent, std::string what) {
  const bool is_there = std::ranges::any_of(
      series_, [&](const PlotSeries& series) { return series.agent == agent && series.what == what; });
  if (is_there) return false;
  series_.push_back({std::move(agent), std::move(what), {}, 0, 0});
  return true;
}

bool Plots::Remove(std::string_view agent, std::string_view what) {
  return std::erase_if(series_,
                       [&](const PlotSeries& series) { return series.agent == agent && series.what == what; }) != 0;
}

void Plots::Point(PlotSeries& series, std::uint64_t tick, double value) {
  series.points.push_back({tick, value});
  if (series.points.size() > kMostPoints) series.points.pop_front();
  const bool is_first = series.points.size() == 1;
  series.minimum = is_first ? value : std::min(series.minimum, value);
  series.maximum = is_first ? value : std::max(series.maximum, value);
}

void Plots::Add(const record::TickRecord& tick) {
  for (const record::MindRecord& mind : tick.minds) record::ApplyPercepts(mind.percepts, percepts_[mind.agent]);
  for (PlotSeries& series : series_) {
    while (!series.points.empty() && series.points.back().tick >= tick.tick) series.points.pop_back();
    std::optional<double> value;
    const record::MindRecord* mind = record::FindMind(tick, series.agent);
    if (series.what == "health" || series.what == "speed") {
      value = OfBody(tick, series.agent, series.what);
    } else if (series.what == "decisions") {
      value = mind == nullptr ? 0.0 : static_cast<double>(mind->decisions.size());
    } else if (series.what == "fired") {
      value =
          mind == nullptr ? 0.0 : static_cast<double>(std::ranges::count_if(mind->details, [](const std::string& d) {
            return d.find(' ') != std::string::npos && std::string_view(d).substr(d.find(' ')).starts_with(" fire ");
          }));
    } else if (const auto known = percepts_.find(series.agent); known != percepts_.end()) {
      if (const auto percept = known->second.find(series.what); percept != known->second.end())
        value = Number(percept->second);
    }
    if (value) Point(series, tick.tick, *value);
  }
}

void Plots::Sample(const sim::Simulation& simulation) {
  for (PlotSeries& series : series_) {
    if (series.what == "decide_us") {
      for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
        const sim::MindReport report = simulation.Mind(i);
        if (report.agent == series.agent) Point(series, simulation.tick(), report.decide_s * 1e6);
      }
    } else if (IsMemoryPath(series.what)) {
      const std::unique_ptr<sim::Inspector> mind = simulation.Inspect(series.agent);
      if (mind == nullptr) continue;
      if (const std::optional<double> value = Follow(*mind, series.what)) Point(series, simulation.tick(), *value);
    }
  }
}

std::vector<std::string> Plottable(sim::Inspector& mind) {
  std::vector<std::string> paths = {"health", "speed", "decisions", "fired", "decide_us"};
  const sim::MindFacts facts = mind.Mind();
  constexpr int kDepth = 4;
  if (!facts.input_link.empty()) NumbersBelow(mind, facts.input_link, facts.input_link, kDepth, paths);
  for (const sim::StateFact& state : mind.Stack())
    for (const sim::ElementFact& element : mind.ElementsOf(state.id))
      if (!element.is_object && Number(element.value)) paths.push_back(state.id + "." + element.attribute);
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

Json ToJson(const std::vector<PlotSeries>& series) {
  Json list = Json::array();
  for (const PlotSeries& one : series) {
    Json json;
    json["agent"] = one.agent;
    json["what"] = one.what;
    json["minimum"] = one.minimum;
    json["maximum"] = one.maximum;
    json["points"] = Json::array();
    for (const PlotPoint& point : one.points) json["points"].push_back(Json::array({point.tick, point.value}));
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace soarbox::debugger
