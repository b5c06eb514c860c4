// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/base/symbol_table.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// Finds numbers that fall between two proposals: one tests that a value is below a number, its sibling that it is
/// above the same number, and no third one takes the number itself. An agent that meets just this number has no
/// operator.
///
/// Siblings are rules that propose operators and whose conditions are the same but for what they compare one value
/// with. Other gaps are not told of: leaving a range out is often meant. Only gaps beside one of the last `fresh` rules
/// count. Each warning stands at the later of the two rules.
std::vector<Diagnostic> FindRuleGaps(std::span<const Production* const> rules, std::size_t fresh,
                                     const SymbolTable& symbols);

}  // namespace soarbox::kernel
