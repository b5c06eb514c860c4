// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "kernel/agent.h"

namespace soarbox {

/// Why this operator is the one that was selected in a goal, in words: "the only one proposed", "better than turn
/// (O3)", "at random among 3 indifferent", and the rule that proposes it. Reads the preferences as they stand at the
/// decision.
std::string ReasonOfOperator(const kernel::Agent& agent, const kernel::GoalInfo& goal);

/// What an impasse is between: "among seek (O1), turn (O3)"; empty for a no-change.
std::string ReasonOfState(const kernel::Agent& agent, const kernel::GoalInfo& goal);

/// The rule that made an element of the output link, or an empty text.
std::string RuleOfOutput(const kernel::Agent& agent, kernel::Symbol attribute, std::uint64_t timetag);

}  // namespace soarbox
