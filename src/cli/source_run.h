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
  /// Rules that were read, and those that went, by a command or for a new one of their name.
  struct Counts {
    int sourced = 0;
    int ignored = 0;
    std::vector<std::string> excised;

    bool empty() const { return sourced + ignored == 0 && excised.empty(); }
  };
  Counts counts;  ///< Since the last file ended, which is how Soar counts for the innermost file.
  Counts total;   ///< Of the files that have ended.
  bool verbose = false, per_file = false, silent = false;  ///< The options of the outermost command.
  std::vector<kernel::FileName> files;                     ///< Files that are open now, as typed; the innermost last.
  /// So many files at most are read for one command, nested or one after the other.
  static constexpr int kMostFiles = 5'000;
  int opened = 0;
  bool stars_pending = false;  ///< Stars stand in the line that the next output would go on in.
  int line = 0;                ///< Of the command that is carried out, in the innermost file.
  /// Where in the answer's diagnostics a warning stands, by a hash of its message: large sources repeat theirs.
  std::unordered_map<std::size_t, std::size_t> warnings;
};

}  // namespace soarbox::cli
