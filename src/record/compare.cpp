// SPDX-License-Identifier: BSD-2-Clause
#include "record/compare.h"

#include <algorithm>
#include <cmath>

#include "record/percept_text.h"

namespace soarbox::record {
namespace {

using Perceived = std::map<std::string, PerceptValues>;

const MindRecord* MindOf(const TickRecord& record, const std::string& agent) {
  const auto at = std::find_if(record.minds.begin(), record.minds.end(),
                               [&](const MindRecord& mind) { return mind.agent == agent; });
  return at == record.minds.end() ? nullptr : &*at;
}

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "; ") + line.substr(line.find_first_not_of(' '));
  return text.empty() ? "nothing" : text;
}

/// The first mind, in A's order, that decided or said something else in A than in B.
std::optional<Difference> DecisionThatDiffers(const TickRecord& a, const TickRecord& b) {
  static const MindRecord kNothing;
  const auto compare = [&](const std::string& agent) -> std::optional<Difference> {
    const MindRecord* in_a = MindOf(a, agent);
    const MindRecord* in_b = MindOf(b, agent);
    const MindRecord& x = in_a != nullptr ? *in_a : kNothing;
    const MindRecord& y = in_b != nullptr ? *in_b : kNothing;
    if (x.decisions != y.decisions)
      return Difference{a.tick, agent, "decision", Joined(x.decisions), Joined(y.decisions)};
    if (x.commands != y.commands) return Difference{a.tick, agent, "command", Joined(x.commands), Joined(y.commands)};
    return std::nullopt;
  };
  for (const TickRecord* record : {&a, &b})
    for (const MindRecord& mind : record->minds)
      if (std::optional<Difference> found = compare(mind.agent)) return found;
  return std::nullopt;
}

std::vector<std::string> PerceptsThatDiffer(const PerceptValues& a, const PerceptValues& b) {
  std::vector<std::string> lines;
  const auto value = [](const PerceptValues& values, const std::string& path) {
    const auto at = values.find(path);
    return at == values.end() ? std::string("none") : at->second;
  };
  for (const PerceptValues* values : {&a, &b}) {
    for (const auto& [path, ignored] : *values) {
      if (value(a, path) == value(b, path) || (values == &b && a.contains(path))) continue;
      lines.push_back(path + ": " + value(a, path) + ", " + value(b, path));
    }
  }
  return lines;
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

Result<Comparison> Compare(Reader& a, Reader& b) {
  Comparison result;
  result.first_tick = std::max(a.first_tick(), b.first_tick());
  result.last_tick = std::min(a.last_tick(), b.last_tick());
  if (result.first_tick > result.last_tick) {
    Diagnostic problem;
    problem.file = a.file().string();
    problem.message = "this recording and " + b.file().string() + " share no tick";
    return problem;
  }
  const double step_s = a.header().step_s;
  const auto ticks_per_moment = static_cast<std::uint64_t>(std::max(1.0, std::round(1 / step_s)));
  Perceived perceived_a, perceived_b;
  for (std::uint64_t tick = result.first_tick; tick <= result.last_tick; ++tick) {
    const Result<const TickRecord*> read_a = a.At(tick);
    if (!read_a) return read_a.error();
    const Result<const TickRecord*> read_b = b.At(tick);
    if (!read_b) return read_b.error();
    const TickRecord& in_a = **read_a;
    const TickRecord& in_b = **read_b;
    if (!result.decision) {
      for (const MindRecord& mind : in_a.minds) ApplyPercepts(mind, perceived_a[mind.agent]);
      for (const MindRecord& mind : in_b.minds) ApplyPercepts(mind, perceived_b[mind.agent]);
      result.decision = DecisionThatDiffers(in_a, in_b);
      if (result.decision)
        result.percepts = PerceptsThatDiffer(perceived_a[result.decision->agent], perceived_b[result.decision->agent]);
    }
    if (!result.difference) result.difference = FirstDifference(in_a, in_b);
    if ((tick - result.first_tick) % ticks_per_moment == 0) result.course.push_back(MomentOf(in_a, in_b));
  }
  return result;
}

}  // namespace soarbox::record
