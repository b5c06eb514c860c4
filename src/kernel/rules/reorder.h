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
  std::vector<Symbol> unconnected;  ///< Root variables without a goal test.
};

/// Puts a rule's conditions into match order, as Soar does: the cheapest next, with one step of look-ahead; creation
/// stamps decide ties (docs/spec/kernel_algorithms.md). Moves every test to the first field where both its sides are
/// bound, and swaps its sides if necessary. Relational tests on unbound variables are dropped from positive conditions
/// and are errors in negated ones. `variables` contains all variables of the conditions; `expected` makes some
/// attributes more expensive.
ReorderOutcome ReorderConditions(RuleDraft& rule, const VariableIndex& variables, const ExpectedValues& expected,
                                 const SymbolTable& symbols, Arena& arena);

}  // namespace soarbox::kernel
