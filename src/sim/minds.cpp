// SPDX-License-Identifier: BSD-2-Clause
#include "sim/minds.h"

#include <algorithm>

namespace soarbox::sim {
namespace {

std::string RulesOfKind(const std::string& kind) {
  return kind + "agent.soar";
}

}  // namespace

Minds::Minds(world::World& world, const Scenario& scenario, SoarHost& host, Report report)
    : world_(world), scenario_(scenario), host_(host), report_(std::move(report)) {}

Result<void> Minds::MakeMind(world::EntityId agent, const script::AgentCreationRequest& request) {
  const world::Agent& body = *world_.FindAgent(agent);
  const std::string wanted = request.rules.empty() ? RulesOfKind(request.kind) : request.rules;
  const std::filesystem::path rules = FindInFolders(wanted, scenario_.rule_folders);
  if (rules.empty()) {
    Diagnostic problem;
    problem.file = wanted;
    problem.message = "the rules of " + body.name() + " are in none of these folders:";
    for (const std::filesystem::path& folder : scenario_.rule_folders) problem.message += " " + folder.string();
    problem.hint = "check the name, or add the folder with --path";
    return problem;
  }
  Result<SoarHost::Loaded> loaded = Load(body.name(), rules);
  if (!loaded) return loaded.error();
  minds_.push_back({agent, request.kind == "follower", rules, SoarMind(*loaded->agent)});
  return {};
}

Result<SoarHost::Loaded> Minds::Load(const std::string& agent, const std::filesystem::path& rules) {
  Result<SoarHost::Loaded> loaded = host_.CreateAgent(agent, rules);
  if (!loaded) return loaded;
  for (Diagnostic& problem : loaded->problems) {
    if (!reported_.insert(Format(problem)).second) continue;
    Event event;
    event.kind = EventKind::kDiagnostic;
    event.agent = agent;
    event.diagnostic = std::move(problem);
    report_(std::move(event));
  }
  return loaded;
}

void Minds::Restore() {
  for (Mind& mind : minds_) {
    const std::string& name = world_.FindAgent(mind.agent)->name();
    Result<SoarHost::Loaded> loaded = Load(name, mind.rules);
    mind.lost = !loaded;
    mind.decided = mind.in_gap = mind.told_halt = false;
    if (loaded) {
      mind.soar = SoarMind(*loaded->agent);
      continue;
    }
    if (!host_.IsConnected()) return;  // Gone again: the next kernel gets them all.
    Event event;
    event.kind = EventKind::kDiagnostic;
    event.agent = name;
    event.diagnostic = loaded.error();
    report_(std::move(event));
  }
}

Minds::Mind* Minds::Find(world::EntityId agent) {
  const auto at = std::lower_bound(minds_.begin(), minds_.end(), agent,
                                   [](const Mind& mind, world::EntityId id) { return mind.agent < id; });
  return at != minds_.end() && at->agent == agent ? &*at : nullptr;
}

void Minds::Decide() {
  for (Mind& mind : minds_) Decide(mind);
}

void Minds::Decide(Mind& mind) {
  const world::Agent& body = *world_.FindAgent(mind.agent);
  mind.decided = false;
  if (body.Failed() || mind.lost || !host_.IsConnected()) return;
  world::Vec3 goal = body.Target();
  const bool has_leader = body.Leader() != world::kNoEntity;
  if (mind.follows_leader && !has_leader) return;  // Nobody to follow: no percept, no command.
  if (const world::Agent* leader = has_leader ? world_.FindAgent(body.Leader()) : nullptr) goal = leader->Position();
  mind.distance_squared_m2 = world::LengthSquared(goal - body.Position());
  mind.soar.Decide(mind.distance_squared_m2);
  if (!host_.IsConnected()) return;  // Its kernel went meanwhile; that is no gap in the rules.
  mind.decided = true;
  if (mind.soar.commands().empty() || !mind.soar.Breakdown().empty()) {
    TellGap(mind, body);
  } else {
    mind.in_gap = false;
  }
}

/// Tells why there is no command.
void Minds::TellGap(Mind& mind, const world::Agent& body) {
  Event event;
  event.kind = EventKind::kGap;
  event.agent = body.name();
  if (!mind.soar.Breakdown().empty()) {
    mind.lost = true;
    event.kind = EventKind::kMindFailed;
    event.diagnostic.file = mind.rules.string();
    event.diagnostic.message =
        body.name() + " ran out of memory and stands still from now on: " + std::string(mind.soar.Breakdown());
    event.diagnostic.hint = "conditions that share no variable match in all combinations of their elements";
    report_(std::move(event));
    return;
  }
  if (mind.soar.Halted()) {
    // In a gap the goal stack grows until the kernel halts the program: start it anew, it did not ask to be halted.
    if (mind.in_gap) {
      mind.soar.Restart();
    } else if (!mind.told_halt) {
      mind.told_halt = true;
      event.text = "its program has halted";
      report_(std::move(event));
    }
    return;
  }
  if (mind.in_gap) return;
  mind.in_gap = true;
  event.text = "no rule answers distance " + std::to_string(mind.distance_squared_m2) + " within the decision budget";
  report_(std::move(event));
}

}  // namespace soarbox::sim
