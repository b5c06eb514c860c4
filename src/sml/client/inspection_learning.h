// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "soarbox_Inspection.h"

namespace soarbox {

/// How an agent learned its rules. See MindInspection.
std::vector<mind::LessonFact> InspectLessons(const kernel::Agent& agent, bool whole, std::string_view rule);

}  // namespace soarbox
