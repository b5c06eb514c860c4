// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::app {

/// The run that the window's user wants to open next. The window then closes, and another one opens with this run.
struct NextRun {
  std::string what;  ///< A scenario's name or path, or a recording.
  bool is_recording = false;
  std::size_t script_line = 0;  ///< The line at which the script of user events (--ui-script) continues.
  std::filesystem::path lesson =
      {};  ///< The folder of the lesson to which the scenario belongs; empty: determined by its name.
};

/// Checks whether this can be opened and determines its kind; else returns the reason.
Result<NextRun> FindNextRun(const std::string& what);
/// Global, because a process has one window at a time: the closing window sets it, and the program takes it.
void KeepNextRun(NextRun next);
std::optional<NextRun> TakeNextRun();

}  // namespace soarbox::app
