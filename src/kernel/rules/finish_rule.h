// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/rules/draft.h"
#include "kernel/rules/expected_values.h"
#include "kernel/rules/parser.h"
#include "kernel/rules/variable_index.h"

namespace soarbox::kernel {

/// Turns a rule in text order into one in match order: orders actions and conditions, checks that they are connected,
/// binds variables (which `variables` has numbered) and sets what follows from the contents (new identifiers, is_rl).
/// Adds Soar's messages to `out.late_messages` and our own to `out.diagnostics`; false if the rule must be refused.
/// Learned rules go through this function as well.
bool FinishRule(RuleDraft& rule, const VariableIndex& variables, const SourcePlace& place, SymbolTable& symbols,
                const ExpectedValues& expected, Arena& arena, ParseOutcome& out);

}  // namespace soarbox::kernel
