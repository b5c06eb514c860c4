// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soarbox::app {

/// Options of `soarbox test`.
struct TestOptions {
  std::vector<std::filesystem::path> paths;  ///< Missions, scenarios, folders; none: all below the current folder.
  std::string seeds;                         ///< "1..20"; empty: the missions' own.
  std::vector<std::string> rules;            ///< "NAME=FILE", as for `soarbox run`.
  int jobs = 0;                              ///< Number of processes; 0: one per processor.
  std::filesystem::path junit;               ///< A report for continuous integration; empty: none.
  bool json = false;
  bool watch = false;          ///< Repeats whenever a file of a mission is saved.
  bool empty = false;          ///< Uses minds without rules: a mission that then passes tests nothing.
  bool no_keep = false;        ///< Keeps no recordings of failed runs.
  std::filesystem::path keep;  ///< The folder of these recordings; empty: the usual one.
};

/// Its exit codes in addition to ExitCode.
enum TestExitCode : int {
  kTestRefused = 3,  ///< A mission or a scenario cannot be used.
  kTestBroken = 4,   ///< A run crashed, hung or is undecided, and there was no worse error.
  kTestNone = 5,     ///< There is no mission.
  kTestInterrupted = 130,
};

int Test(const TestOptions& options);

}  // namespace soarbox::app
