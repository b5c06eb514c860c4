// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "kernel/rules/file_name.h"

namespace soarbox::cli {

/// What a source command has loaded so far, nested files included.
struct SourceRun {
  /// Rules that were read, and rules that were removed by a command or replaced by one of the same name.
  struct Counts {
    int sourced = 0;
    int ignored = 0;
    std::vector<std::string> excised;

    bool empty() const { return sourced + ignored == 0 && excised.empty(); }
  };
  Counts counts;  ///< Since the last file ended, which is how Soar counts for the innermost file.
  Counts total;   ///< Of the files that have ended.
  bool verbose = false, per_file = false, silent = false;  ///< The options of the outermost command.
  std::vector<kernel::FileName> files;                     ///< Files that are now open, as typed; the innermost last.
  /// One command reads at most so many files, nested or one after the other.
  static constexpr int kMostFiles = 5'000;
  int opened = 0;
  bool stars_pending = false;  ///< Stars are in the line in which the next output would continue.
  int line = 0;                ///< Of the current command, in the innermost file.
  /// Where a warning is in the answer's diagnostics, by a hash of its message: large sources repeat theirs.
  std::unordered_map<std::size_t, std::size_t> warnings;
};

}  // namespace soarbox::cli
