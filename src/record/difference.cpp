// SPDX-License-Identifier: BSD-2-Clause
#include "record/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

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

std::optional<Difference> DifferenceOfMinds(const TickRecord& recorded, const TickRecord& now) {
  if (recorded.minds.empty() || now.minds.empty()) return std::nullopt;  // A level that tells nothing of minds.
  const std::size_t count = std::max(recorded.minds.size(), now.minds.size());
  for (std::size_t i = 0; i < count; ++i) {
    static const MindRecord kNothing;
    const MindRecord& a = i < recorded.minds.size() ? recorded.minds[i] : kNothing;
    const MindRecord& b = i < now.minds.size() ? now.minds[i] : kNothing;
    const std::pair<const char*, std::vector<std::string> MindRecord::*> parts[] = {
        {"percepts", &MindRecord::percepts},
        {"decisions", &MindRecord::decisions},
        {"commands", &MindRecord::commands},
        {"reasons", &MindRecord::reasons},
        {"commands' rules", &MindRecord::command_rules}};
    for (const auto& [element, part] : parts) {
      if (a.agent == b.agent && a.*part == b.*part) continue;
      return Difference{recorded.tick, a.agent.empty() ? b.agent : a.agent, element, Text(a.*part), Text(b.*part)};
    }
  }
  return std::nullopt;
}

std::string Joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += (text.empty() ? "" : "; ") + line.substr(line.find_first_not_of(' '));
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

}  // namespace soarbox::record
