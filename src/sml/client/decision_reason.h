// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "kernel/agent.h"

namespace soarbox {

/// Appends why this operator is the one that was selected in a goal, in words: "the only one proposed", "better than
/// turn (O3)", "at random, one of 3 indifferent ones", and the rule that proposes it. Reads the preferences as they
/// stand at the decision. `is_forced`: `decide select` or `decide predict` had settled it before.
void AppendReasonOfOperator(const kernel::Agent& agent, const kernel::GoalInfo& goal, bool is_forced,
                            std::string& text);

/// What an impasse is between: "among seek (O1), turn (O3)"; empty for a no-change.
std::string ReasonOfState(const kernel::Agent& agent, const kernel::GoalInfo& goal);

/// The rule that made an element of the output link, or an empty text. Valid while the element is there.
std::string_view RuleOfOutput(const kernel::Agent& agent, kernel::Symbol attribute, std::uint64_t timetag);

}  // namespace soarbox
