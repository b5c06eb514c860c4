// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace soarbox::editors {

struct ProgramLimits {
  double seconds = 120;                ///< Of real time; then the program is killed.
  std::size_t output_bytes = 4 << 20;  ///< Of each of its two outputs; the rest is dropped.
};

struct ProgramEnd {
  int code = -1;        ///< Its exit code; -1: it did not start, or a signal ended it.
  bool hung = false;    ///< It took too long.
  bool is_cut = false;  ///< It printed more than was kept.
  std::string out, err;
};

/// Runs a program with these arguments (the first is its path), nothing on its standard input, and waits for its end.
ProgramEnd RunProgram(const std::vector<std::string>& arguments, const ProgramLimits& limits = {});

}  // namespace soarbox::editors
