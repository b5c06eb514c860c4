// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/agent_rules.h"

#include <algorithm>
#include <cstdint>

#include "kernel/decide/engine.h"

namespace soarbox::kernel {
namespace {

/// The approximate memory of a learned rule, including its conditions in the network (some of which other rules share).
std::size_t LearnedBytes(const Production& rule) {
  constexpr std::size_t kNetworkPerCondition_bytes = 256;
  return rule.MemoryBytes() + rule.conditions.size() * kNetworkPerCondition_bytes;
}

}  // namespace

ProductionId AgentRules::Find(std::string_view name) const {
  const Symbol symbol = engine_.symbols.FindString(name);
  return symbol ? engine_.rules.Named(symbol) : ProductionId::kNone;
}

AgentRules::Outcome AgentRules::Add(const ProductionPtr& rule) {
  const LoadOutcome outcome = engine_.agent.AddProduction(rule, true);
  engine_.run.StopIfBroken();
  return {outcome.production, outcome.loaded};
}

void AgentRules::NoteAdded(ProductionId id, const ProductionPtr& production) {
  const bool running = engine_.agent.running();
  const std::uint32_t index = Index(id);
  if (engine_.productions.size() <= index) engine_.productions.resize(index + 1u);
  ProductionRecord record;
  record.Set(ProductionRecord::kLive, true);
  record.Set(ProductionRecord::kHasNegations, std::ranges::any_of(production->conditions, [](const Condition& c) {
               return c.kind != ConditionKind::kPositive;
             }));
  record.Set(ProductionRecord::kLearned, running);
  if (running) engine_.learned_rule_bytes += LearnedBytes(*production);
  engine_.productions[index] = record;
  engine_.rules.Add(id, engine_.NameOf(*production), production->type);
  if (!running) engine_.rules_changed = true;  // Rules that an agent learns are not shared.
  engine_.interrupts.erase(id);
  engine_.modules.RuleAdded(id, *production);
  if (engine_.rete.matches().HasInterrupting()) engine_.run.TellInterrupts();
  engine_.observers.Notify(Event::kProduction, [&](Observer& o) { o.OnProductionAdded(engine_.agent, id); });
}

void AgentRules::Excise(ProductionId id) {
  if (Index(id) >= engine_.productions.size() || !engine_.productions[Index(id)].Is(ProductionRecord::kLive)) return;
  engine_.observers.Notify(Event::kProduction, [&](Observer& o) { o.OnProductionExcised(engine_.agent, id); });
  const ProductionPtr rule = engine_.rete.production(id);
  engine_.modules.RuleExcised(id);
  ProductionRecord& record = engine_.productions[Index(id)];
  if (record.Is(ProductionRecord::kLearned)) engine_.learned_rule_bytes -= LearnedBytes(*rule);
  record.Set(ProductionRecord::kLive, false);
  engine_.rules.Remove(id, engine_.NameOf(*rule), rule->type);
  engine_.rules_changed = true;
  if (engine_.run.running()) {
    LeaveMatch(id);
  } else {
    engine_.rete.ExciseProduction(id);
  }
}

void AgentRules::LeaveMatch(ProductionId production) {
  engine_.excisions.push_back(production);
}

}  // namespace soarbox::kernel
