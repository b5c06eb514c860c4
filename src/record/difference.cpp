// SPDX-License-Identifier: BSD-2-Clause
#include "record/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "wording/mind_words.h"

namespace soarbox::record {
namespace {

std::string Text(world::Vec3 v) {
  return fmt::format("({}, {}, {})", v.x, v.y, v.z);
}

std::string Text(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "; ") + line;
  return text.empty() ? "nothing" : text;
}

/// The percepts, with all digits of numbers.
std::string Exact(const mind::EventLog& events) {
  std::vector<std::string> lines;
  events.ForEachOf<mind::PerceptChanged>([&](const mind::PerceptChanged& percept) {
    std::string line = wording::PerceptPath(percept.path, percept.attribute, percept.key) + " ";
    if (const auto* number = std::get_if<double>(&percept.value)) {
      line += fmt::format("{}", *number);
    } else {
      line += wording::ValueText(percept.value);
    }
    lines.push_back(std::move(line));
  });
  return Text(lines);
}

std::optional<Difference> DifferenceOfBodies(const TickRecord& recorded, const TickRecord& now) {
  Difference found;
  found.tick = recorded.tick;
  const std::size_t count = std::max(recorded.scene.agents.size(), now.scene.agents.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= recorded.scene.agents.size() || i >= now.scene.agents.size()) {
      const bool more = i >= recorded.scene.agents.size();
      found.agent = more ? now.scene.agents[i].name : recorded.scene.agents[i].name;
      found.element = "presence";
      found.recorded = more ? "absent" : "present";
      found.now = more ? "present" : "absent";
      return found;
    }
    const world::AgentSnapshot& a = recorded.scene.agents[i];
    const world::AgentSnapshot& b = now.scene.agents[i];
    found.agent = a.name;
    const auto differs = [&](const char* element, const std::string& was, const std::string& is) {
      found.element = element;
      found.recorded = was;
      found.now = is;
      return found;
    };
    if (a.name != b.name) return differs("name", a.name, b.name);
    if (a.last_command != b.last_command) return differs("command", a.last_command, b.last_command);
    if (a.position != b.position) return differs("position", Text(a.position), Text(b.position));
    if (a.velocity != b.velocity) return differs("velocity", Text(a.velocity), Text(b.velocity));
    if (a.forward != b.forward) return differs("heading", Text(a.forward), Text(b.forward));
    if (a.health != b.health) return differs("health", std::to_string(a.health), std::to_string(b.health));
  }
  return std::nullopt;
}

/// Without firings and elements, which are not in recordings of a lower level.
mind::EventLog WithoutDetails(const MindRecord& mind) {
  mind::EventLog events = mind.events;
  events.DropDetails();
  return events;
}

/// The first difference of two minds in words, if they differ.
std::optional<Difference> DifferenceOf(const MindRecord& a, const MindRecord& b, std::uint64_t tick) {
  if (a.agent == b.agent && a.events == b.events) return std::nullopt;
  const mind::EventLog was = WithoutDetails(a), is = WithoutDetails(b);
  if (a.agent == b.agent && was == is) return std::nullopt;
  const std::string& agent = a.agent.empty() ? b.agent : a.agent;
  const wording::MindWords old_words = wording::Words(was), new_words = wording::Words(is);
  const std::pair<const char*, std::vector<std::string> wording::MindWords::*> parts[] = {
      {"percepts", &wording::MindWords::percepts},
      {"decisions", &wording::MindWords::decisions},
      {"commands", &wording::MindWords::commands},
      {"reasons", &wording::MindWords::reasons},
      {"commands' rules", &wording::MindWords::command_rules}};
  for (const auto& [element, part] : parts) {
    if (a.agent != b.agent || old_words.*part != new_words.*part)
      return Difference{tick, agent, element, Text(old_words.*part), Text(new_words.*part)};
  }
  // The percepts print equally, or the sentences do not mention the preferences.
  const bool in_percepts = Exact(was) != Exact(is);
  return Difference{tick, agent, in_percepts ? "percepts" : "preferences", in_percepts ? Exact(was) : "others",
                    in_percepts ? Exact(is) : "others"};
}

std::optional<Difference> DifferenceOfMinds(const TickRecord& recorded, const TickRecord& now) {
  if (recorded.minds.empty() || now.minds.empty()) return std::nullopt;  // A level without minds.
  const auto has_done_something = [](const MindRecord& mind) { return !WithoutDetails(mind).empty(); };
  auto a = recorded.minds.begin(), b = now.minds.begin();
  static const MindRecord kNothing;
  while (true) {
    a = std::find_if(a, recorded.minds.end(), has_done_something);
    b = std::find_if(b, now.minds.end(), has_done_something);
    const bool has_a = a != recorded.minds.end(), has_b = b != now.minds.end();
    if (!has_a && !has_b) return std::nullopt;
    if (std::optional<Difference> found = DifferenceOf(has_a ? *a : kNothing, has_b ? *b : kNothing, recorded.tick))
      return found;
    ++a;
    ++b;
  }
}

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines)
    text += (text.empty() ? "" : "; ") + line.substr(std::min(line.find_first_not_of(' '), line.size()));
  return text.empty() ? "nothing" : text;
}

}  // namespace

std::optional<Difference> FirstDifference(const TickRecord& recorded, const TickRecord& now, bool with_minds) {
  if (recorded.inputs != now.inputs)
    return Difference{recorded.tick, "", "inputs", Text(recorded.inputs), Text(now.inputs)};
  if (with_minds)
    if (std::optional<Difference> minds = DifferenceOfMinds(recorded, now)) return minds;
  if (std::optional<Difference> bodies = DifferenceOfBodies(recorded, now)) return bodies;
  if (recorded.state_hash != now.state_hash) {
    return Difference{recorded.tick, "", "the state's hash", fmt::format("{:016x}", recorded.state_hash),
                      fmt::format("{:016x}", now.state_hash)};
  }
  return std::nullopt;
}

std::optional<Difference> DecisionThatDiffers(const TickRecord& a, const TickRecord& b) {
  static const MindRecord kNothing;
  const auto compare = [&](const std::string& agent) -> std::optional<Difference> {
    const MindRecord* in_a = FindMind(a, agent);
    const MindRecord* in_b = FindMind(b, agent);
    if (in_a != nullptr && in_b != nullptr && in_a->events == in_b->events) return std::nullopt;
    const wording::MindWords x = wording::Words((in_a != nullptr ? *in_a : kNothing).events, false);
    const wording::MindWords y = wording::Words((in_b != nullptr ? *in_b : kNothing).events, false);
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

}  // namespace soarbox::record
