// SPDX-License-Identifier: BSD-2-Clause
#include "cli/rule_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/rules/print_production.h"

namespace soarbox::cli {

using kernel::Agent;
using kernel::Production;
using kernel::ProductionId;

std::string RuleText(const Agent& agent, const Production& rule, bool internal) {
  return kernel::PrintProduction(agent.symbols(), rule, {.internal = internal}) + "\n";
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
  std::string value;
  kernel::AppendRhsValue(value, agent.symbols(), rule.actions.front().referent);
  return fmt::format(" {:f} {}", 0.0, value);
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
