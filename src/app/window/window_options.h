// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/window_wishes.h"
#include "diagnostics/result.h"
#include "sim/scenario.h"
#include "viewer/viewer.h"

namespace soarbox::app {

/// What a window is opened with, except its size and title. A hidden one is for a picture. The error names a panel
/// that does not exist.
Result<viewer::ViewerOptions> WindowOptionsOf(const WindowWishes& wishes, const sim::DataFolders& data, bool hidden);

/// When a window that a user saw has closed: keeps the user's own arrangement of panels, and tells what stopped the
/// script that played the user. Returns the ExitCode given, or that of the script.
int AfterWindow(const viewer::Viewer& viewer, const WindowWishes& wishes, int code);

}  // namespace soarbox::app
