// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "kernel/rules/file_name.h"

namespace soarbox::cli {

/// The files and rules that a source command has loaded so far, including nested files.
struct SourceRun {
  /// Number of rules that were read, and rules that were excised by a command or replaced by one of the same name.
  struct Counts {
    int sourced = 0;
    int ignored = 0;
    std::vector<std::string> excised;

    bool empty() const { return sourced + ignored == 0 && excised.empty(); }
  };
  Counts counts;  ///< Since the end of the last file. Like Soar, these are printed as the counts of the innermost file.
  Counts total;   ///< Of the files that have ended.
  bool verbose = false, per_file = false, silent = false;  ///< The options of the outermost command.
  std::vector<kernel::FileName> files;                     ///< Absolute paths of the open files; the innermost is the
                                                           ///< last.
  /// Maximum number of files that one command reads, nested or one after another.
  static constexpr int kMostFiles = 5'000;
  int opened = 0;              ///< Number of files so far.
  bool stars_pending = false;  ///< The last printed line ends with stars, so the next output must begin on a new line.
  int line = 0;                ///< Line of the current command in the innermost file.
  /// Index of each warning in the answer's diagnostics, by a hash of its message, because large sources repeat
  /// warnings.
  std::unordered_map<std::size_t, std::size_t> warnings;
};

}  // namespace soarbox::cli
