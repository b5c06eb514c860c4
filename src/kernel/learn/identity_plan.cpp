// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/identity_plan.h"

#include <algorithm>
#include <utility>

#include "kernel/rules/draft.h"

namespace soarbox::kernel {

std::uint16_t IdentityPlan::ClassOf(Symbol variable) const {
  for (std::size_t n = 0; n < variables.size(); ++n) {
    if (variables[n] == variable) return static_cast<std::uint16_t>(n);
  }
  return kLiteral;
}

namespace {

/// Maps variables to classes while a plan is built. Learned rules have many variables.
class ClassTable {
 public:
  /// Returns the class of a variable; a new variable gets the class `next`.
  std::uint16_t FindOrAdd(Symbol variable, std::uint16_t next) {
    if (2 * (used_ + 1) > slots_.size()) Grow();
    Entry& entry = Find(variable);
    if (!entry.variable) {
      entry = {variable, next};
      ++used_;
    }
    return entry.identity_class;
  }

 private:
  struct Entry {
    Symbol variable;
    std::uint16_t identity_class = 0;
  };
  Entry& Find(Symbol variable) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = (variable.bits() * 0x9E3779B1u >> 16) & mask;
    while (slots_[slot].variable && slots_[slot].variable != variable) slot = (slot + 1) & mask;
    return slots_[slot];
  }
  void Grow() {
    const std::vector<Entry> old =
        std::exchange(slots_, std::vector<Entry>(std::max<std::size_t>(32, 2 * slots_.size())));
    for (const Entry& entry : old) {
      if (entry.variable) Find(entry.variable) = entry;
    }
  }

  std::vector<Entry> slots_;  ///< A hash table whose size is a power of two.
  std::size_t used_ = 0;
};

}  // namespace

IdentityPlan IdentityPlan::Of(const Production& rule) {
  IdentityPlan plan;
  ClassTable classes;
  plan.of_field.reserve(3 * rule.conditions.size());
  for (const Condition& condition : rule.conditions) {
    if (condition.kind != ConditionKind::kPositive) continue;
    for (const Test* test : {&condition.id, &condition.attribute, &condition.value}) {
      const Symbol symbol = EqualitySymbol(*test);
      std::uint16_t known = kLiteral;
      if (!symbol || symbol.IsVariable()) {
        known = symbol ? classes.FindOrAdd(symbol, plan.bound()) : plan.bound();
        if (known == plan.bound()) {
          plan.first.push_back(static_cast<std::uint16_t>(plan.of_field.size()));
          plan.variables.push_back(symbol);
        }
      }
      if (std::ranges::any_of(test->parts(), [](const Test& part) { return part.kind == TestKind::kLiteral; })) {
        plan.literal.push_back(static_cast<std::uint16_t>(plan.of_field.size()));
      }
      plan.of_field.push_back(known);
    }
  }
  return plan;
}

}  // namespace soarbox::kernel
