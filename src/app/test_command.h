// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soarbox::app {

/// What `soarbox test` was asked for.
struct TestOptions {
  std::vector<std::filesystem::path> paths;  ///< Missions, scenarios, folders; none: all below the present folder.
  std::string seeds;                         ///< "1..20"; empty: the missions' own.
  std::vector<std::string> rules;            ///< "NAME=FILE", as for `soarbox run`.
  int jobs = 0;                              ///< Processes at a time; 0: one per processor.
  std::filesystem::path tap;                 ///< The same in the Test Anything Protocol; empty: none.
  std::filesystem::path junit;               ///< A report for continuous integration; empty: none.
  bool json = false;
  bool watch = false;          ///< Again whenever a file of a mission is saved.
  bool empty = false;          ///< With minds that have no rules: a mission that passes like this tests nothing.
  bool no_keep = false;        ///< No recordings of runs that fail.
  std::filesystem::path keep;  ///< Where they are kept; empty: the usual folder.
};

/// What its exit status means, besides ExitCode.
enum TestExitCode : int {
  kTestRefused = 3,  ///< A mission or a scenario cannot be used.
  kTestBroken = 4,   ///< A run crashed, hung, or is undecided, and nothing worse.
  kTestNone = 5,     ///< There is no mission.
  kTestInterrupted = 130,
};

int Test(const TestOptions& options);

}  // namespace soarbox::app
