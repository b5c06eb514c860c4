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
  int sourced = 0;
  int excised = 0;
  int ignored = 0;
  std::vector<std::string> excised_names;
  std::vector<kernel::FileName> files;  ///< Files that are open now, as typed; the innermost last.
  bool stars_pending = false;           ///< Stars stand in the line that the next output would go on in.
  int line = 0;                         ///< Of the command that is carried out, in the innermost file.
  /// Where in the answer's diagnostics a warning stands, by a hash of its message: large sources repeat theirs.
  std::unordered_map<std::size_t, std::size_t> warnings;
};

}  // namespace soarbox::cli
