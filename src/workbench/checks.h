// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "sim/run_event.h"
#include "workbench/contents.h"

namespace soarbox::workbench {

/// Notes what an event says of a check of the run's mission: that there is one, or that it was decided. False: it says
/// nothing of a check.
bool NoteCheck(const sim::RunEvent& event, std::vector<CheckRow>& checks);

}  // namespace soarbox::workbench
