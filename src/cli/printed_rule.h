// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "kernel/agent.h"

namespace soarbox::cli {

/// A rule as `print` shows it, from "sp {" to the closing brace and an empty line. `internal`: one condition and one
/// action per line, in the form that the matcher uses.
std::string RuleText(const kernel::Agent& agent, const kernel::Production& rule, bool internal);

/// One condition as text: "(<s> ^a <x>)".
std::string ConditionText(const kernel::Agent& agent, const kernel::Condition& condition);

/// A rule's name, in bars if necessary.
std::string RuleName(const kernel::Agent& agent, std::string_view name);
inline std::string RuleName(const kernel::Agent& agent, const kernel::Production& rule) {
  return RuleName(agent, rule.name);
}

/// " UPDATES VALUE" for a rule that reinforcement learning can change (with delta-bar-delta " BETA H UPDATES VALUE");
/// else empty.
std::string LearnedValueText(const kernel::Agent& agent, const kernel::Production& rule);

/// The rules of one type, newest first.
std::vector<kernel::ProductionId> RulesOfType(const kernel::Agent& agent, kernel::ProductionType type);

/// The rule with this name, with or without bars; kNone if there is none.
kernel::ProductionId FindRule(const kernel::Agent& agent, std::string_view name);

}  // namespace soarbox::cli
