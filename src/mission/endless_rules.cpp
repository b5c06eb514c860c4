// SPDX-License-Identifier: BSD-2-Clause
#include "mission/endless_rules.h"

#include <algorithm>

#include "explain/inspector.h"
#include "mission/check_sentences.h"
#include "sim/simulation.h"

namespace soarbox::mission {
namespace {

/// Number of elaborations in one tick that agents reach only if their rules fire endlessly. max-elaborations is 100.
constexpr std::uint64_t kLimit = 50;

/// Number of states that an agent reaches only if each substate leads to another one. max-goal-depth is 23.
constexpr std::size_t kMostStates = 60;

/// Explains a goal stack that grows without end: the operator that is selected in the newest states, and its proposal.
/// Empty if no operator is selected: the impasse of the first state is the cause then, and other findings explain it.
std::string GrowingStack(const std::string& agent, explain::Inspector& mind,
                         const std::vector<explain::StateFact>& stack) {
  std::string text = "the goal stack of " + agent + " grows without end";
  const auto newest = std::find_if(stack.rbegin(), stack.rend(),
                                   [](const explain::StateFact& state) { return !state.operator_id.empty(); });
  if (newest == stack.rend()) return {};
  text += ": in each substate " + newest->operator_name + " is selected again, and leads to another substate";
  for (const explain::PreferenceFact& preference : mind.Operators(newest->id).preferences)
    if (preference.type == "acceptable" && preference.value == newest->operator_id && !preference.maker.rule.empty())
      return text + "; rule " + preference.maker.rule +
             " proposes it there, too: test what only the first state has, such as ^superstate nil or a ^name";
  return text;
}

}  // namespace

bool EndlessRules::See(const sim::EventList& events, sim::Simulation& simulation) {
  for (const sim::RunEvent& event : events) {
    // Its mind was halted because its rules fired very often in one tick.
    if (event.diagnostic.message.find(" stops for good: its rules fired ") != std::string::npos) {
      text_ = event.diagnostic.message + (event.diagnostic.hint.empty() ? "" : "; " + event.diagnostic.hint);
      return true;
    }
    if (event.kind != sim::EventKind::kDiagnostic ||
        !event.diagnostic.message.starts_with("rules fire again and again in one phase"))
      continue;
    Agent& agent = agents_[event.agent];
    agent.text = event.diagnostic.message + (event.diagnostic.hint.empty() ? "" : "; " + event.diagnostic.hint);
  }
  for (auto& [name, agent] : agents_) {
    const auto inspector = simulation.Inspect(name);
    if (inspector == nullptr) continue;
    const std::uint64_t elaborations = inspector->Mind().elaborations;
    if (agent.elaborations > 0 && elaborations >= agent.elaborations + kLimit) ++agent.ticks;
    agent.elaborations = elaborations;
    if (agent.ticks < kMostTicks) continue;
    text_ = agent.text + ". The run was ended at " + SecondsText(simulation.time_s());
    return true;
  }
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const std::string agent = simulation.AgentOfMind(i);
    const auto inspector = simulation.Inspect(agent);
    if (inspector == nullptr || !inspector->TellsAll()) continue;
    const std::vector<explain::StateFact> stack = inspector->Stack();
    if (stack.size() < kMostStates) continue;
    const std::string cause = GrowingStack(agent, *inspector, stack);
    if (cause.empty()) continue;
    text_ = cause + ". The run was ended at " + SecondsText(simulation.time_s());
    return true;
  }
  return false;
}

}  // namespace soarbox::mission
