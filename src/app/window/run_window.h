// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/run_options.h"
#include "app/run_session.h"
#include "app/window.h"

namespace soarbox::app {

/// Runs in a window until it is closed, the time is over or the screenshot is taken. Returns an ExitCode.
int RunWindow(RunSession& session, const RunOptions& options, const sim::DataFolders& data, const WindowRun& run);

}  // namespace soarbox::app
