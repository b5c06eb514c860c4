// SPDX-License-Identifier: BSD-2-Clause
#include "app/mind_steps.h"

#include <memory>
#include <vector>

namespace soarbox::app {
namespace {

/// The operator of the lowest state that has one, "seek (O3)"; or the current impasse.
std::string WhatItIsAbout(sim::Simulation& simulation, const std::string& agent) {
  const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(agent);
  if (mind == nullptr) return {};
  const std::vector<explain::StateFact> stack = mind->Stack();
  for (auto state = stack.rbegin(); state != stack.rend(); ++state) {
    if (state->operator_id.empty()) continue;
    return state->operator_name.empty() ? state->operator_id : state->operator_name + " (" + state->operator_id + ")";
  }
  return {};
}

std::string StandsIn(sim::Simulation& simulation, const std::string& agent) {
  const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(agent);
  if (mind == nullptr) return {};
  const std::vector<explain::StateFact> stack = mind->Stack();
  if (stack.size() < 2) return {};
  return stack.back().attribute + " " + stack.back().impasse;
}

std::string SaidIn(const sim::Simulation& simulation, const std::string& agent) {
  for (const world::AgentSnapshot& body : simulation.Snapshot().agents)
    if (body.name == agent) return body.last_command;
  return {};
}

std::string StepDecision(RunSession& session, const std::string& agent) {
  constexpr const char* kBudget = "soar max-nil-output-cycles";
  sim::Simulation& simulation = session.simulation();
  if (simulation.sends_commands_elsewhere()) {
    const Result<std::string> ran = simulation.Command(agent, "run --decision 1 --self");
    if (!ran) return ran.error().message;
    session.Idle();
    return agent + ": one decision";
  }
  const Result<std::string> budget = simulation.Command(agent, kBudget);
  if (!budget) return budget.error().message;
  std::string number;
  for (const char c : *budget)
    if (c >= '0' && c <= '9') number += c;
  const std::string before = WhatItIsAbout(simulation, agent), said_before = SaidIn(simulation, agent);
  if (const Result<std::string> set = simulation.Command(agent, std::string(kBudget) + " 1"); !set)
    return set.error().message;
  session.Tick();
  sim::Simulation& after = session.simulation();
  if (!number.empty()) static_cast<void>(after.Command(agent, std::string(kBudget) + " " + number));
  const std::string now = WhatItIsAbout(after, agent), impasse = StandsIn(after, agent);
  std::string told = agent + ": ";
  if (!impasse.empty() && impasse != "operator no-change")
    told += "one decision, impasse " + impasse;
  else if (now.empty())
    told += "one decision, no operator";
  else
    told += now == before ? "one decision, still " + now : "decided " + now;
  if (const std::string said = SaidIn(after, agent); !said.empty() && said != said_before) told += ", gave " + said;
  return told;
}

std::string StepPhase(RunSession& session, const std::string& agent) {
  sim::Simulation& simulation = session.simulation();
  const Result<std::string> answer = simulation.Command(agent, "run -p 1 --self");
  if (!answer) return answer.error().message;
  const bool is_elsewhere = simulation.sends_commands_elsewhere();
  if (is_elsewhere) session.Idle();
  std::string next;
  if (const std::unique_ptr<explain::Inspector> mind = simulation.Inspect(agent)) next = mind->Mind().phase;
  return agent + ": one phase" + (next.empty() ? "" : ", next is " + next) +
         (is_elsewhere ? "" : "; the world is paused and takes its commands in the next tick");
}

}  // namespace

MindStepped StepMind(RunSession& session, const std::string& agent, MindStep step) {
  if (agent.empty()) return {"Select the Soar agent whose mind is to take a step"};
  if (!session.simulation().HasMind(agent)) return {agent + " has no Soar mind to step"};
  if (step == MindStep::kPhase) return {StepPhase(session, agent), session.simulation().sends_commands_elsewhere()};
  return {StepDecision(session, agent), true};
}

}  // namespace soarbox::app
