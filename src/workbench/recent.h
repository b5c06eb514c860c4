// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soarbox::workbench {

/// Scenarios and recordings that were opened in a window, the newest first. Leaves out those that no longer exist.
std::vector<std::string> RecentRuns();
/// Stores that this was opened: the name of a scenario, or a path.
void NoteRecentRun(const std::string& what);

}  // namespace soarbox::workbench
