// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

class ExpectedValues;
class RuleChanges;
class SymbolTable;
class WorkingMemory;

/// Makes rules out of templates: for each match of a rule with :template one rule rl*NAME*n that has the matched
/// constants in place of variables, and whose number is learned on its own. Identifiers stay variables. Of comparisons
/// only `<>` between identifiers stays: all others hold for the constants. A rule that there is already is not made
/// again.
class RlTemplates {
 public:
  /// What it uses of the agent.
  struct Uses {
    SymbolTable& symbols;
    const WorkingMemory& memory;
    const ExpectedValues& expected_values;
    RuleChanges& rule_changes;
  };
  explicit RlTemplates(const Uses& uses) : uses_(uses) {}

  /// A template matched these elements, one for each positive condition, and its action gave this value. No rule is
  /// made of a value that is no number. The new rule is matched at once.
  void Instantiate(ProductionId source, const Production& rule, std::span<const WmeId> wmes, Symbol value);
  /// A rule was loaded: one that is called rl*NAME*n, as saved ones are, makes the numbers go on behind it.
  void RuleAdded(std::string_view name);
  void RuleExcised(ProductionId rule);

 private:
  /// What a match gives to its rule: the constants, and which identifiers are equal.
  using Pattern = std::vector<std::uint64_t>;

  Pattern PatternOf(ProductionId source, std::span<const WmeId> wmes) const;
  ProductionPtr Build(const Production& rule, std::span<const WmeId> wmes, Symbol value, std::string_view name) const;

  Uses uses_;
  std::uint64_t next_ = 1;                ///< Of all templates together.
  std::map<Pattern, ProductionId> made_;  ///< So that a template that fires again costs little.
};

}  // namespace soarbox::kernel
