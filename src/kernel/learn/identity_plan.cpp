// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/identity_plan.h"

#include <algorithm>

#include "kernel/rules/draft.h"

namespace soarbox::kernel {

std::uint16_t IdentityPlan::ClassOf(Symbol variable) const {
  for (std::size_t n = 0; n < variables.size(); ++n) {
    if (variables[n] == variable) return static_cast<std::uint16_t>(n);
  }
  return kLiteral;
}

void IdentityPlan::AddField(Symbol symbol) {
  std::uint16_t known = symbol ? ClassOf(symbol) : kLiteral;
  if (known == kLiteral) {
    known = bound();
    first.push_back(static_cast<std::uint16_t>(of_field.size()));
    variables.push_back(symbol);
  }
  of_field.push_back(known);
}

IdentityPlan IdentityPlan::Of(const Production& rule) {
  IdentityPlan plan;
  plan.of_field.reserve(3 * rule.conditions.size());
  for (const Condition& condition : rule.conditions) {
    if (condition.kind != ConditionKind::kPositive) continue;
    for (const Test* test : {&condition.id, &condition.attribute, &condition.value}) {
      const Symbol symbol = EqualitySymbol(*test);
      if (std::ranges::any_of(test->parts(), [](const Test& part) { return part.kind == TestKind::kLiteral; })) {
        plan.literal.push_back(static_cast<std::uint16_t>(plan.of_field.size()));
      }
      if (!symbol || symbol.IsVariable()) {
        plan.AddField(symbol);
      } else {
        plan.of_field.push_back(kLiteral);
      }
    }
  }
  return plan;
}

}  // namespace soarbox::kernel
