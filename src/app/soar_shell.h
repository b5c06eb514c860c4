// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <vector>

namespace soarbox::app {

/// Options of `soarbox soar`.
struct SoarShellOptions {
  std::vector<std::filesystem::path> files;  ///< Sourced first, in order.
  bool json = false;                         ///< One JSON object per command instead of text.
};

/// The interactive shell of the Soar command language for one agent: with editing, history and completion at a
/// terminal; as a script when input is piped. Ctrl-C stops a run; Ctrl-D or `exit` ends the shell. Returns an ExitCode:
/// kProblems if a piped or sourced command failed.
int RunSoarShell(const SoarShellOptions& options);

}  // namespace soarbox::app
