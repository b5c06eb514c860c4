// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/run_options.h"

namespace soarbox::app {

/// Options of `soarbox learn`.
struct LearnOptions {
  std::vector<std::string>
      words;  ///< None: list the lessons. "4", "next": begin a lesson. "check 4", "hint 4", "reset 4", "test".
  std::filesystem::path folder;  ///< The folder of the learner's files; empty: ~/soarbox-lessons.
  std::filesystem::path from;    ///< A folder with a teacher's own lessons; empty: those of the program.
  bool json = false;
  bool headless = false;  ///< Do not open the window.
  bool progress = false;  ///< `check` prints a line after each seed, for programs.
  RunOptions window;      ///< Options of the window; the lesson determines the world.
};

/// The beginning of each line of `--progress`: "seed 3 of 10".
inline constexpr std::string_view kProgressLine = "seed ";

int Learn(const LearnOptions& options);

}  // namespace soarbox::app
