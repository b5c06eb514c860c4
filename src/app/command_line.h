// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::app {

class PageServer;
class Window;

/// The soarbox command: does what its arguments ask for. `window` shows runs and recordings, `server` serves pages;
/// null: this program has none. Returns an ExitCode.
int CommandLine(int argc, char** argv, const Window* window, const PageServer* server);

}  // namespace soarbox::app
