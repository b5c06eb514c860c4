// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/window_wishes.h"
#include "diagnostics/result.h"
#include "sim/scenario.h"
#include "viewer/viewer.h"

namespace soarbox::app {

/// Returns the options of a window except its size and title. `hidden` is for pictures. The error names a panel that
/// does not exist.
Result<viewer::ViewerOptions> WindowOptionsOf(const WindowWishes& wishes, const sim::DataFolders& data, bool hidden);

/// Call it after a visible window has closed. Saves the user's arrangement of panels, and reports the error of the
/// script that played the user. Returns `code`, or the ExitCode of the script.
int AfterWindow(const viewer::Viewer& viewer, const WindowWishes& wishes, int code);

}  // namespace soarbox::app
