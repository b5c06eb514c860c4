// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/symbol_table.h"
#include "kernel/rules/parser.h"

namespace soarbox::kernel {

/// A small set of variables.
class VariableSet {
 public:
  bool Has(Symbol variable) const {
    for (const Symbol member : members_) {
      if (member == variable) {
        return true;
      }
    }
    return false;
  }
  void Add(Symbol variable) {
    if (variable.IsVariable() && !Has(variable)) {
      members_.push_back(variable);
    }
  }
  void Remove(Symbol variable) { std::erase(members_, variable); }
  const std::vector<Symbol>& members() const { return members_; }

 private:
  std::vector<Symbol> members_;
};

struct ReorderOutcome {
  bool ok = true;
  std::vector<RuleMessage> messages;
  std::vector<Symbol> unconnected;         ///< Root variables that no goal test names.
};

/// Brings a rule's conditions into match order, as Soar does (kernel_algorithms: cheapest next, one step of look-ahead,
/// ties by creation stamps), and moves every test to the first place where both its sides are bound, turned round if
/// need be. Relational tests that nothing binds vanish from positive conditions and are errors in negated ones.
ReorderOutcome ReorderConditions(std::string_view rule_name, std::vector<Condition>& conditions,
                                 const SymbolTable& symbols);

}  // namespace soarbox::kernel
