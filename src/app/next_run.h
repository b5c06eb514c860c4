// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::app {

/// What a window's user wants to see next: the window closes, and another one opens on it.
struct NextRun {
  std::string what;  ///< A scenario's name or path, or a recording.
  bool is_recording = false;
  std::size_t script_line = 0;        ///< Where a script that plays the user goes on.
  std::filesystem::path lesson = {};  ///< The folder of the lesson that the scenario belongs to; empty: as it is named.
};

/// Whether this can be opened, and what it is; else why not.
Result<NextRun> FindNextRun(const std::string& what);
/// One for the whole process, which has one window at a time: the closing window sets it, the program takes it.
void KeepNextRun(NextRun next);
std::optional<NextRun> TakeNextRun();

}  // namespace soarbox::app
