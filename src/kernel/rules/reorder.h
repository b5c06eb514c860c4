// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "kernel/base/symbol_table.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/expected_values.h"
#include "kernel/rules/parser.h"
#include "kernel/rules/variable_index.h"

namespace soarbox::kernel {

struct ReorderOutcome {
  bool ok = true;
  std::vector<RuleMessage> messages;
  std::vector<Symbol> unconnected;  ///< Root variables that no goal test names.
};

/// Puts a rule's conditions into match order, as Soar does (kernel_algorithms: cheapest next, one step of look-ahead,
/// ties by creation stamps), and moves every test to the first place where both its sides are bound, turned round if
/// necessary. Relational tests on unbound variables are dropped from positive conditions and are errors in negated
/// ones. `variables` has numbered all variables of the conditions; `expected` makes some attributes more expensive.
ReorderOutcome ReorderConditions(RuleDraft& rule, const VariableIndex& variables, const ExpectedValues& expected,
                                 const SymbolTable& symbols, Arena& arena);

}  // namespace soarbox::kernel
