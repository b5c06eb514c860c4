// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "mind/rule_facts.h"

namespace soarbox::kernel {
class Production;
class SymbolTable;
}  // namespace soarbox::kernel

/// Converts rules to facts with the kernel's own parser, which is the only parser of Soar rules. It needs no agent, so
/// that it can also read what an official kernel prints.
namespace soarbox::rule_reading {

/// The content of a parsed rule.
mind::RuleFacts FactsOf(const kernel::Production& rule, const kernel::SymbolTable& symbols);

/// Parses rules that a kernel printed (`print --full`), one after another. Skips other text and rules that cannot be
/// parsed.
std::vector<mind::RuleFacts> ReadPrintedRules(std::string_view text);

/// Parses conditions as `matches` prints them: "(<in> ^agent <a>)", "(<s> -^done)".
std::vector<mind::RuleConditionFact> ReadPrintedConditions(std::string_view text);

}  // namespace soarbox::rule_reading
