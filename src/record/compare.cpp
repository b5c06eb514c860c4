// SPDX-License-Identifier: BSD-2-Clause
#include "record/compare.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnostics/problem.h"
#include "mind/decision_codec.h"
#include "wording/decision_text.h"

namespace soarbox::record {
namespace {

std::vector<std::string> PerceptsThatDiffer(const PerceptValues& a, const PerceptValues& b) {
  std::vector<std::string> lines;
  const auto value = [](const PerceptValues& values, const std::string& path) {
    const auto at = values.find(path);
    return at == values.end() ? std::string("none") : TextOf(at->second);
  };
  for (const PerceptValues* values : {&a, &b}) {
    for (const auto& [path, ignored] : *values) {
      if (value(a, path) == value(b, path) || (values == &b && a.contains(path))) continue;
      lines.push_back(path + ": " + value(a, path) + ", " + value(b, path));
    }
  }
  return lines;
}

/// Explains why an agent selected its last operator in this tick.
std::string WhyDecided(const TickRecord& tick, std::string_view agent, bool& by_chance) {
  std::string why;
  const auto take = [&](const mind::OperatorSelected& selected) {
    const std::optional<mind::Decision> decision = mind::Unpack(selected.decision);
    if (!decision || decision->empty()) return;
    why = wording::WhySelected(*decision);
    by_chance |= decision->left.size() > 1;
  };
  for (const MindRecord& mind : tick.minds)
    if (mind.agent == agent) mind.events.ForEach(mind::Cases{take, [](const auto&) {}});
  return why;
}

Comparison::Moment MomentOf(const TickRecord& a, const TickRecord& b) {
  Comparison::Moment moment;
  moment.time_s = a.scene.time_s;
  std::size_t compared = 0;
  for (const world::AgentSnapshot& agent : a.scene.agents) {
    moment.health_a += static_cast<double>(agent.health);
    moment.alive_a += agent.alive ? 1 : 0;
    const auto same = std::find_if(b.scene.agents.begin(), b.scene.agents.end(),
                                   [&](const world::AgentSnapshot& other) { return other.name == agent.name; });
    if (same == b.scene.agents.end()) continue;
    const auto distance = static_cast<double>(world::Distance(agent.position, same->position));
    moment.mean_distance_m += distance;
    ++compared;
    if (distance > moment.greatest_distance_m) {
      moment.greatest_distance_m = distance;
      moment.farthest = agent.name;
    }
  }
  if (compared > 0) moment.mean_distance_m /= static_cast<double>(compared);
  for (const world::AgentSnapshot& agent : b.scene.agents) {
    moment.health_b += static_cast<double>(agent.health);
    moment.alive_b += agent.alive ? 1 : 0;
  }
  return moment;
}

}  // namespace

Comparer::Comparer(double step_s)
    : ticks_per_moment_(static_cast<std::uint64_t>(std::max(1.0, std::round(1 / step_s)))) {}

void Comparer::Share(const std::string& agent, const mind::EventLog& events) {
  ApplyPercepts(events, perceived_a_[agent]);
  ApplyPercepts(events, perceived_b_[agent]);
}

void Comparer::See(const TickRecord& a, const TickRecord& b) {
  if (!std::exchange(has_begun_, true)) result_.first_tick = a.tick;
  result_.last_tick = a.tick;
  if (!result_.decision) {
    for (const MindRecord& mind : a.minds) ApplyPercepts(mind.events, perceived_a_[mind.agent]);
    for (const MindRecord& mind : b.minds) ApplyPercepts(mind.events, perceived_b_[mind.agent]);
    result_.decision = DecisionThatDiffers(a, b);
    if (result_.decision) {
      const std::string& agent = result_.decision->agent;
      result_.percepts = PerceptsThatDiffer(perceived_a_[agent], perceived_b_[agent]);
      result_.why_a = WhyDecided(a, agent, result_.by_chance);
      result_.why_b = WhyDecided(b, agent, result_.by_chance);
    }
  }
  if (!result_.difference) result_.difference = FirstDifference(a, b);
  if ((a.tick - result_.first_tick) % ticks_per_moment_ == 0) result_.course.push_back(MomentOf(a, b));
}

Result<Comparison> Compare(TickSource& a, TickSource& b) {
  const std::uint64_t first = std::max(a.first_tick(), b.first_tick());
  const std::uint64_t last = std::min(a.last_tick(), b.last_tick());
  if (first > last) {
    return ProblemIn(a.name(), "this recording and " + b.name() + " share no tick");
  }
  Comparer comparer(a.header().step_s);
  for (std::uint64_t tick = first; tick <= last; ++tick) {
    const Result<const TickRecord*> in_a = a.At(tick);
    if (!in_a) return in_a.error();
    const Result<const TickRecord*> in_b = b.At(tick);
    if (!in_b) return in_b.error();
    comparer.See(**in_a, **in_b);
  }
  return comparer.result();
}

}  // namespace soarbox::record
