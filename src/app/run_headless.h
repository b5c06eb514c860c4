// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/run_options.h"
#include "app/run_session.h"

namespace soarbox::app {

/// Runs without a window, as fast as possible or at the requested speed. Long runs show their progress on stderr if it
/// is a terminal. Returns an ExitCode.
int RunHeadless(RunSession& session, const RunOptions& options);

}  // namespace soarbox::app
