// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "sim/run_event.h"
#include "workbench/contents.h"

namespace soarbox::workbench {

/// Updates `checks` from an event about a check of the run's mission: the check exists, or it has a result. Returns
/// false if the event is not about a check.
bool NoteCheck(const sim::RunEvent& event, std::vector<CheckRow>& checks);

}  // namespace soarbox::workbench
