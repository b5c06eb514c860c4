// SPDX-License-Identifier: BSD-2-Clause
#include "cli/printed_rule.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/learn/rl_settings.h"
#include "kernel/learn/rl_values.h"
#include "kernel/rules/print_production.h"

namespace soarbox::cli {

using kernel::Agent;
using kernel::Production;
using kernel::ProductionId;

namespace {

/// If it is the agent's own rule, returns it with its learned value.
std::shared_ptr<const Production> AsLearned(const Agent& agent, const Production& rule) {
  const std::shared_ptr<const Production> itself(std::shared_ptr<const Production>(), &rule);
  if (!rule.is_rl) return itself;
  const ProductionId id = agent.FindProduction(rule.name);
  if (id == ProductionId::kNone || agent.production_ptr(id).get() != &rule) return itself;
  return agent.ProductionAsLearned(id);
}

}  // namespace

std::string RuleText(const Agent& agent, const Production& rule, bool internal) {
  return kernel::PrintProduction(agent.symbols(), *AsLearned(agent, rule), {.internal = internal}) + "\n";
}

std::string ConditionText(const Agent& agent, const kernel::Condition& condition) {
  std::string text;
  kernel::AppendCondition(text, agent.symbols(), condition);
  return text;
}

std::string RuleName(const Agent& agent, std::string_view name) {
  const kernel::Symbol symbol = agent.symbols().FindString(name);
  return symbol ? kernel::ToString(agent.symbols(), symbol) : std::string(name);
}

std::string LearnedValueText(const Agent& agent, const Production& rule) {
  if (!rule.is_rl || rule.actions.empty()) return {};
  const ProductionId id = agent.FindProduction(rule.name);
  const kernel::RlValue* const learned = id == ProductionId::kNone ? nullptr : agent.LearnedValue(id);
  std::string number;
  if (learned != nullptr) {
    number = kernel::ToString(agent.symbols(), learned->value);
  } else {
    kernel::AppendRhsValue(number, agent.symbols(), rule.actions.front().referent);
  }
  const kernel::RlValue known = learned != nullptr ? *learned : kernel::RlValue();
  if (agent.reinforcement().decay == kernel::RlDecay::kDeltaBarDelta) {
    return fmt::format(" {:f} {:f} {:f} {}", known.beta, known.h, known.updates, number);
  }
  return fmt::format(" {:f} {}", known.updates, number);
}

std::vector<ProductionId> RulesOfType(const Agent& agent, kernel::ProductionType type) {
  std::vector<ProductionId> rules;
  for (const ProductionId id : agent.Productions()) {
    if (agent.production(id).type == type) rules.push_back(id);
  }
  std::reverse(rules.begin(), rules.end());
  return rules;
}

ProductionId FindRule(const Agent& agent, std::string_view name) {
  const ProductionId id = agent.FindProduction(name);
  if (id != ProductionId::kNone || name.size() < 2 || name.front() != '|' || name.back() != '|') return id;
  std::string text;
  for (std::size_t i = 1; i + 1 < name.size(); ++i) {
    if (name[i] == '\\' && i + 2 < name.size()) ++i;
    text += name[i];
  }
  return agent.FindProduction(text);
}

}  // namespace soarbox::cli
