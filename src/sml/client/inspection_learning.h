// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "soarbox_Inspection.h"

namespace soarbox {

/// The constants that the positive conditions of a rule test: "^name move ^row 3". Without ^type, ^impasse and
/// ^superstate, and at most kMostConstants of them.
inline constexpr int kMostConstants = 6;
std::string ConstantsOf(const kernel::Agent& agent, const kernel::Production& production);

/// How an agent learned its rules. See MindInspection.
std::vector<mind::LearnedRuleFact> InspectLessons(const kernel::Agent& agent, bool whole, std::string_view rule);

}  // namespace soarbox
