// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
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
  bool progress = false;  ///< `check` prints a line for each seed that is done, for a program that reads it.
  RunOptions window;      ///< Its size and what else is asked of it; which world it shows comes from the lesson.
};

/// How each line of `--progress` begins: "seed 3 of 10".
inline constexpr std::string_view kProgressLine = "seed ";

int Learn(const LearnOptions& options);

}  // namespace soarbox::app
