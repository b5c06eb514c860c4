// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/base/symbol_table.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/variable_index.h"

namespace soarbox::kernel {

/// Renames the variables of a rule whose own names Soar does not keep (chunks and justifications): <s1> for states,
/// otherwise a letter from the attribute before the first occurrence and a number, in match order. Call before the
/// actions' variables are bound. Variables keep their numbers.
void RenameVariables(RuleDraft& rule, const VariableIndex& variables, SymbolTable& symbols);

}  // namespace soarbox::kernel
