// SPDX-License-Identifier: BSD-2-Clause
// Answers to *why* about agents and their minds.
#include <algorithm>
#include <cstdio>

#include "diagnostics/problem.h"
#include "explain/reasons.h"
#include "sim/minds.h"
#include "sim/senses.h"
#include "sml_Client.h"
#include "wording/sentences.h"

namespace soarbox::sim {
namespace {

using explain::WhyKind;
using wording::Say;
using wording::Situation;

std::string Seconds(double time_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", time_s);
  return text;
}

std::string DeathText(const Arena& arena, world::EntityId agent) {
  const auto death = arena.past().deaths.find(agent);
  if (death == arena.past().deaths.end()) return Say(Situation::kDead);
  return Say(Situation::kDied, {{"time", Seconds(death->second.time_s)}, {"how", death->second.how}});
}

/// The status of a command without an answer.
std::string StatusOf(bool is_dead, bool has_ended) {
  if (is_dead) return "not finished when the agent died";
  return has_ended ? "over" : "under way";
}

}  // namespace

Result<std::vector<explain::WhyNode>> Minds::WhyTopic(std::string_view agent, const std::string& topic) {
  Mind* mind = FindNamed(agent);
  if (mind == nullptr) return NewProblem("there is no agent '" + std::string(agent) + "' with a mind");
  if (mind->gone) return std::vector<explain::WhyNode>{{mind->gone_because}};
  return explain::MindReasons(mind->soar.agent(), FailedIn(mind->rules)).WhyTopic(topic, KnownAttributes());
}

void Minds::NoteDecisions(Mind& mind) {
  if (mind.settings.detail == MindDetail::kNone) return;
  mind.clock.Note(static_cast<std::uint64_t>(mind.soar.agent().GetDecisionCycleCounter()), world_.time_s(),
                  world_.settings().step_s);
}

explain::DecisionTime Minds::TimeOf(const Mind& mind) const {
  return [clock = &mind.clock](std::uint64_t decision) { return clock->TimeOf(decision); };
}

explain::WhyNode Minds::WhyCommand(Mind& mind, explain::MindReasons& reasons, bool is_dead, bool has_ended) {
  if (!mind.last_said) return {"has given no command", WhyKind::kCommand};
  const std::string& command = mind.last_said->name;
  const std::string parameters = vocabulary::Describe(mind.last_said->parameters);
  const std::string status = mind.last_answer.empty() ? StatusOf(is_dead, has_ended) : mind.last_answer;
  explain::WhyNode node{"command " + command + (parameters.empty() ? "" : " " + parameters) + ", given at " +
                            Seconds(mind.last_said_s) + " s: " + status,
                        WhyKind::kCommand, command, reasons.CommandTree(command, TimeOf(mind))};
  node.failed = mind.failed_command == command;
  return node;
}

std::optional<explain::WhyNode> Minds::Why(std::string_view agent, bool with_operators) {
  Mind* at = FindNamed(agent);
  if (at == nullptr) return std::nullopt;
  const world::Agent& body = *world_.FindAgent(at->agent);
  explain::WhyNode root{body.name() + " at " + Seconds(world_.time_s()) + " s", WhyKind::kAgent, body.name()};
  const auto add = [&root](std::string line) -> explain::WhyNode& {
    return root.below.emplace_back(explain::WhyNode{std::move(line)});
  };
  if (body.IsGone()) {
    add("is no longer there: a script removed it");
    return root;
  }
  if (at->gone) {
    add(at->gone_because);
    return root;
  }
  explain::MindReasons reasons(at->soar.agent(), FailedIn(at->rules));
  Actor* actor = arena_.Find(at->agent);
  const bool is_dead = body.Health() <= 0;
  // A command without an answer is running until its body has no more commands.
  const bool has_ended = !at->last_answer.empty() || (actor != nullptr && actor->running().empty());
  if (is_dead) add(DeathText(arena_, at->agent));
  root.below.push_back(WhyCommand(*at, reasons, is_dead, has_ended));
  if (is_dead) return root;
  if (with_operators)
    for (explain::WhyNode& op : reasons.OperatorTree()) root.below.push_back(std::move(op));
  if (at->soar.Halted()) {
    std::string halted = Say(Situation::kHalted);
    if (const std::string why = reasons.WhyHalted(); !why.empty()) halted += ": " + why;
    add(std::move(halted));
  } else if (!at->last_said || has_ended) {
    explain::WhyNode& idle = add("nothing is under way, because");
    if (!at->failed_command.empty()) idle.below.push_back({"its last command " + at->last_answer});
    for (explain::Reason& reason : reasons.WhyIdle(KnownAttributes())) {
      // An operator whose command failed stays selected. Its proposal is not the cause.
      const bool is_result =
          !at->failed_command.empty() && reason.kind == explain::Reason::Kind::kStalled && reason.rule.empty();
      if (!is_result) idle.below.push_back({std::move(reason.text)});
    }
  }
  if (at->settings.has_distance) add("perceives ^distance " + std::to_string(at->distance_squared_m2));
  if (actor != nullptr) {
    explain::WhyNode& perceives = add("perceives");
    for (const vocabulary::Percept& percept : AllPercepts(*actor))
      perceives.below.push_back(
          {"^" + percept.attribute + " " + vocabulary::DescribeValue(percept), WhyKind::kPercept});
  }
  return root;
}

}  // namespace soarbox::sim
