// SPDX-License-Identifier: BSD-2-Clause
#include "mission/endless_rules.h"

#include "explain/inspector.h"
#include "mission/check_sentences.h"
#include "sim/simulation.h"

namespace soarbox::mission {
namespace {

/// Agents reach this number of elaborations in one tick only if their rules fire endlessly. The kernel's default limit,
/// max-elaborations, is 100.
constexpr std::uint64_t kLimit = 50;

}  // namespace

bool EndlessRules::See(const sim::EventList& events, sim::Simulation& simulation) {
  for (const sim::RunEvent& event : events) {
    // The mind was halted because its rules fired very often in one tick.
    if (event.diagnostic.topic == Topic::kHaltedAtWork) {
      text_ = event.diagnostic.message + (event.diagnostic.hint.empty() ? "" : "; " + event.diagnostic.hint);
      return true;
    }
    if (event.diagnostic.topic != Topic::kEndless) continue;
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
  return false;
}

}  // namespace soarbox::mission
