// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::app {

struct CommandOptions;

/// Executes a sub-command that needs no window: all but run, watch, learn, replay in a window, and pages. Returns an
/// ExitCode. It is not part of soarbox-window: otherwise a user's first build, which is made to open a window, would
/// compile sweeps, reports and servers for editors.
int ExecuteWindowless(const std::string& command, const CommandOptions& options);

}  // namespace soarbox::app
