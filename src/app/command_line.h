// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::app {

class PageServer;
class Window;
struct CommandOptions;

/// Executes a command that needs no window (windowless_commands.h).
using WindowlessCommands = int(const std::string& command, const CommandOptions& options);

/// What a program contains besides the command line; null: it does not contain it. If a command needs it, the program
/// replaces itself by one that does.
struct ProgramParts {
  const Window* window = nullptr;      ///< Shows runs and recordings.
  const PageServer* server = nullptr;  ///< Serves pages.
  WindowlessCommands* windowless = nullptr;
};

/// Executes the soarbox command with these arguments. Returns an ExitCode.
int CommandLine(int argc, char** argv, const ProgramParts& parts);

}  // namespace soarbox::app
