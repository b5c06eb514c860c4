// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soarbox::workbench {

/// Scenarios and recordings that were opened in a window, the newest first; those that are gone are left out.
std::vector<std::string> RecentRuns();
/// Remembers that this was opened: a scenario's name, or a path.
void NoteRecentRun(const std::string& what);

}  // namespace soarbox::workbench
