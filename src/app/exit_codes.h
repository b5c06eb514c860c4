// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::app {

/// The exit codes of the soarbox command; docs/command.md lists them for users.
enum ExitCode : int {
  kOk = 0,
  kProblems = 1,     ///< It finished, but found errors in the user's files (reported on stderr).
  kUsage = 2,        ///< The command line was wrong.
  kCannotStart = 3,  ///< The scenario, a file, the port or the display could not be used.
};

}  // namespace soarbox::app
