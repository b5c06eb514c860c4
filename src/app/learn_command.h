// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/run_options.h"

namespace soarbox::app {

/// What `soarbox learn` was asked for.
struct LearnOptions {
  std::vector<std::string> words;  ///< Nothing: the list. "4", "next": begin. "check 4", "hint 4", "reset 4", "test".
  std::filesystem::path folder;    ///< Where the learner's files are; empty: ~/soarbox-lessons.
  std::filesystem::path from;      ///< A folder with lessons of a teacher's own; empty: those of the program.
  bool json = false;
  bool headless = false;  ///< Do not open the window.
  RunOptions window;      ///< Its size and what else is asked of it; which world it shows comes from the lesson.
};

int Learn(const LearnOptions& options);

}  // namespace soarbox::app
