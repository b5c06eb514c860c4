// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/run_options.h"
#include "app/run_session.h"
#include "record/header.h"
#include "sim/scenario.h"

namespace soarbox::app {

/// Whether this build can open a window at all (CMake option SOARBOX_VIEWER).
extern const bool kHasWindow;

/// Width and height of a window in px.
struct WindowSize {
  int width = 1280, height = 720;
};
/// What was asked for. If nothing was, a window for somebody to look at takes most of the display, and a picture or a
/// window that a script uses has the same size everywhere.
WindowSize WindowSizeOf(const RunOptions& options);

/// What a run was made from, so that a window can make it again; kept up to date when it begins again.
struct WindowRun {
  const sim::Scenario& scenario;
  const sim::SimulationSettings& settings;
  const record::Header& header;
};

/// Runs in a window until it is closed, the time is up or the screenshot is taken. Returns an ExitCode.
int RunWindow(RunSession& session, const RunOptions& options, const sim::DataFolders& data, const WindowRun& run);

}  // namespace soarbox::app
