// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/agent.h"

namespace soarbox::cli {

/// An agent's counters before a run, which the report on the run needs.
struct RunCounts {
  std::uint64_t cycles = 0;
  std::uint64_t firings = 0;
  std::uint64_t chunks = 0;

  static RunCounts Of(const kernel::Agent& agent);
};

/// The report of a run as `run` prints it, in parts: "\n\n--> 1 decision cycle executed. 2 rules fired. ", and the
/// reason if it was stopped early.
std::vector<std::string> RunLines(const kernel::Agent& agent, const RunCounts& before, const kernel::RunResult& run);

/// The pieces joined.
std::string RunText(const kernel::Agent& agent, const RunCounts& before, const kernel::RunResult& run);

}  // namespace soarbox::cli
