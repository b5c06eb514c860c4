// SPDX-License-Identifier: BSD-2-Clause
#include <iostream>

#include "app/exit_codes.h"
#include "app/run_window.h"

namespace soarbox::app {

const bool kHasWindow = false;

WindowSize WindowSizeOf(const RunOptions&) {
  return {};
}

int RunWindow(RunSession&, const RunOptions&, const sim::DataFolders&, const WindowRun&) {
  std::cerr << "soarbox: error: this build has no window; build with -DSOARBOX_VIEWER=ON, or use --headless\n";
  return kCannotStart;
}

}  // namespace soarbox::app
