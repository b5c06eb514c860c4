// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/identity_plan.h"

#include "kernel/rules/draft.h"

namespace soarbox::kernel {

std::uint16_t IdentityPlan::ClassOf(Symbol variable) const {
  for (std::size_t n = 0; n < variables.size(); ++n) {
    if (variables[n] == variable) return static_cast<std::uint16_t>(n);
  }
  return kLiteral;
}

IdentityPlan IdentityPlan::Of(const Production& rule) {
  IdentityPlan plan;
  for (const Condition& condition : rule.conditions) {
    if (condition.kind != ConditionKind::kPositive) continue;
    for (const Test* test : {&condition.id, &condition.attribute, &condition.value}) {
      const Symbol symbol = EqualitySymbol(*test);
      std::uint16_t known = kLiteral;
      if (!symbol || symbol.IsVariable()) {
        if (symbol) known = plan.ClassOf(symbol);
        if (known == kLiteral) {
          known = plan.bound();
          plan.first.push_back(static_cast<std::uint16_t>(plan.of_field.size()));
          plan.variables.push_back(symbol);
        }
      }
      plan.of_field.push_back(known);
    }
  }
  return plan;
}

}  // namespace soarbox::kernel
