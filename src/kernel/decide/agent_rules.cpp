// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/agent_rules.h"

#include <algorithm>
#include <cstdint>

#include "kernel/decide/agent_core.h"

namespace soarbox::kernel {
namespace {

/// The approximate memory of a learned rule, including its conditions in the network (some of which other rules share).
std::size_t LearnedBytes(const Production& rule) {
  constexpr std::size_t kNetworkPerCondition_bytes = 256;
  return rule.MemoryBytes() + rule.conditions.size() * kNetworkPerCondition_bytes;
}

}  // namespace

ProductionId AgentRules::Find(std::string_view name) const {
  const Symbol symbol = core_.symbols.FindString(name);
  return symbol ? core_.rules.Named(symbol) : ProductionId::kNone;
}

AgentRules::Outcome AgentRules::Add(const ProductionPtr& rule) {
  const LoadOutcome outcome = core_.agent.AddProduction(rule, true);
  core_.run.StopIfBroken();
  return {outcome.production, outcome.loaded};
}

void AgentRules::NoteAdded(ProductionId id, const ProductionPtr& production) {
  const bool running = core_.agent.running();
  const std::uint32_t index = Index(id);
  if (core_.productions.size() <= index) core_.productions.resize(index + 1u);
  ProductionRecord record;
  record.Set(ProductionRecord::kLive, true);
  record.Set(ProductionRecord::kHasNegations, std::ranges::any_of(production->conditions, [](const Condition& c) {
               return c.kind != ConditionKind::kPositive;
             }));
  record.Set(ProductionRecord::kLearned, running);
  if (running) core_.learned_rule_bytes += LearnedBytes(*production);
  core_.productions[index] = record;
  core_.rules.Add(id, core_.NameOf(*production), production->type);
  if (!running) core_.rules_changed = true;  // Rules that an agent learns are not shared.
  core_.interrupts.erase(id);
  core_.modules.RuleAdded(id, *production);
  if (core_.rete.matches().HasInterrupting()) core_.run.TellInterrupts();
  core_.observers.Notify(Event::kProduction, [&](Observer& o) { o.OnProductionAdded(core_.agent, id); });
}

void AgentRules::Excise(ProductionId id) {
  if (Index(id) >= core_.productions.size() || !core_.productions[Index(id)].Is(ProductionRecord::kLive)) return;
  core_.observers.Notify(Event::kProduction, [&](Observer& o) { o.OnProductionExcised(core_.agent, id); });
  const ProductionPtr rule = core_.rete.production(id);
  core_.modules.RuleExcised(id);
  ProductionRecord& record = core_.productions[Index(id)];
  if (record.Is(ProductionRecord::kLearned)) core_.learned_rule_bytes -= LearnedBytes(*rule);
  record.Set(ProductionRecord::kLive, false);
  core_.rules.Remove(id, core_.NameOf(*rule), rule->type);
  core_.rules_changed = true;
  if (core_.run.running()) {
    LeaveMatch(id);
  } else {
    core_.rete.ExciseProduction(id);
  }
}

void AgentRules::LeaveMatch(ProductionId production) {
  core_.excisions.push_back(production);
}

}  // namespace soarbox::kernel
