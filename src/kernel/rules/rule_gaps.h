// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/base/symbol_table.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// Finds numbers that no proposal accepts. One rule tests that a value is below a number, and a sibling tests that it
/// is above the same number. No third rule accepts the number itself. So at exactly this number the agent has no
/// operator.
///
/// Siblings are rules that propose operators and have equal conditions except for the comparisons of one value. Other
/// gaps are not reported, because users often omit a range on purpose. Only gaps next to one of the last `fresh` rules
/// are reported. The place of each warning is the later of the two rules.
std::vector<Diagnostic> FindRuleGaps(std::span<const Production* const> rules, std::size_t fresh,
                                     const SymbolTable& symbols);

}  // namespace soarbox::kernel
