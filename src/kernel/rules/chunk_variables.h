// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/base/symbol_table.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/variable_index.h"

namespace soarbox::kernel {

/// Renames the variables of a chunk or justification as Soar does: <s1> for states; otherwise a letter taken from the
/// attribute before the first occurrence, and a number, in match order. Variables keep their VariableIndex numbers.
/// Must be called before the variables of the actions are bound.
void RenameVariables(RuleDraft& rule, const VariableIndex& variables, SymbolTable& symbols);

}  // namespace soarbox::kernel
