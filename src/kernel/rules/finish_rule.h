// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/rules/draft.h"
#include "kernel/rules/expected_values.h"
#include "kernel/rules/parser.h"
#include "kernel/rules/variable_index.h"

namespace soarbox::kernel {

/// Converts a rule from text order to match order: orders actions and conditions, checks that they are connected, binds
/// the variables (numbered in `variables`) and sets derived properties (new identifiers, is_rl). Appends Soar's
/// messages to `out.late_messages` and our own to `out.diagnostics`. Returns false if the rule must be refused. Also
/// used for learned rules.
bool FinishRule(RuleDraft& rule, const VariableIndex& variables, const SourcePlace& place, SymbolTable& symbols,
                const ExpectedValues& expected, Arena& arena, ParseOutcome& out);

}  // namespace soarbox::kernel
