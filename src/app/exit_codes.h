// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::app {

/// What the soarbox command's exit status means; docs/command.md lists them for users.
enum ExitCode : int {
  kOk = 0,
  kProblems = 1,     ///< It ran to the end, but something that the user wrote was faulty (each told on stderr).
  kUsage = 2,        ///< The command line was wrong.
  kCannotStart = 3,  ///< The scenario, a file, the port or the display could not be used.
};

}  // namespace soarbox::app
