// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/base/symbol_table.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// Finds numbers that fall between two proposals: one rule tests that a value is below a number, its sibling tests that
/// it is above the same number, and no third rule accepts the number itself. An agent that meets exactly this number
/// has no operator.
///
/// Siblings are rules that propose operators and have the same conditions except for what they compare one value with.
/// Other gaps are not reported: users often leave out a range on purpose. Only gaps beside one of the last `fresh`
/// rules count. Each warning is at the later of the two rules.
std::vector<Diagnostic> FindRuleGaps(std::span<const Production* const> rules, std::size_t fresh,
                                     const SymbolTable& symbols);

}  // namespace soarbox::kernel
