// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::app {

class PageServer;
class Window;

/// Executes the soarbox command with these arguments. `window` shows runs and recordings, `server` serves pages; null:
/// this program has none. Returns an ExitCode.
int CommandLine(int argc, char** argv, const Window* window, const PageServer* server);

}  // namespace soarbox::app
