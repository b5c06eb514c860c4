// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "mind/rule_facts.h"

namespace soarbox::kernel {
class Production;
class SymbolTable;
}  // namespace soarbox::kernel

/// Rules as facts, read by the kernel's own reader: there is no other reader of Soar. It needs no agent, so that it
/// also reads what an official kernel prints.
namespace soarbox::rule_reading {

/// What a parsed rule says.
mind::RuleFacts FactsOf(const kernel::Production& rule, const kernel::SymbolTable& symbols);

/// The rules of a text that a kernel printed (`print --full`), one after another. Skips other text and what cannot be
/// read.
std::vector<mind::RuleFacts> ReadPrintedRules(std::string_view text);

/// Conditions alone, as `matches` prints them: "(<in> ^agent <a>)", "(<s> -^done)".
std::vector<mind::RuleConditionFact> ReadPrintedConditions(std::string_view text);

}  // namespace soarbox::rule_reading
