// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
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
};

}  // namespace soarbox::cli
