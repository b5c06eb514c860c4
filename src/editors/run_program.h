// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace soarbox::editors {

struct ProgramLimits {
  double seconds = 120;                ///< Real time after which the program is killed.
  std::size_t output_bytes = 4 << 20;  ///< Limit for each of its two outputs; further output is dropped.
};

struct ProgramEnd {
  int code = -1;        ///< Its exit code; -1 if it did not start or was ended by a signal.
  bool hung = false;    ///< It exceeded the time limit.
  bool is_cut = false;  ///< Its output was truncated.
  std::string out, err;
};

/// Runs a program with these arguments (the first is its path) and empty standard input, and waits for its end.
ProgramEnd RunProgram(const std::vector<std::string>& arguments, const ProgramLimits& limits = {});

}  // namespace soarbox::editors
