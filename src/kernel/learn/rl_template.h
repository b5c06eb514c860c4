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

/// Builds rules from templates. For each match of a rule with :template, it adds one rule rl*NAME*n with the matched
/// constants instead of variables. The number of each such rule is learned separately. Identifiers remain variables. Of
/// all comparisons, only `<>` between identifiers is kept: the others are true for the constants. A rule that exists
/// already is not added again.
class RlTemplates {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    SymbolTable& symbols;
    const WorkingMemory& memory;
    const ExpectedValues& expected_values;
    RuleChanges& rule_changes;
  };
  explicit RlTemplates(const Uses& uses) : uses_(uses) {}

  /// A template matched these elements, one per positive condition, and its action computed `value`. If the value is
  /// not a number, no rule is added. The new rule is matched immediately.
  void Instantiate(ProductionId source, const Production& rule, std::span<const WmeId> wmes, Symbol value);
  /// A rule was loaded. If its name is rl*NAME*n, as that of a saved rule, later numbers continue after n.
  void RuleAdded(std::string_view name);
  void RuleExcised(ProductionId rule);

 private:
  /// The properties of a match that determine its rule: the constants, and which identifiers are equal.
  using Pattern = std::vector<std::uint64_t>;

  Pattern PatternOf(ProductionId source, std::span<const WmeId> wmes) const;
  ProductionPtr Build(const Production& rule, std::span<const WmeId> wmes, Symbol value, std::string_view name) const;

  Uses uses_;
  std::uint64_t next_ = 1;                ///< Shared by all templates.
  std::map<Pattern, ProductionId> made_;  ///< Avoids rebuilding the rule when a template fires again.
};

}  // namespace soarbox::kernel
