// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kernel/agent.h"

namespace soarbox::cli {

/// What has to be known of an agent before a run in order to report on the run.
struct RunCounts {
  std::uint64_t cycles = 0;
  std::uint64_t firings = 0;
  std::uint64_t chunks = 0;

  static RunCounts Of(const kernel::Agent& agent);
};

/// The report of a run as `run` answers it, in pieces: "\n\n--> 1 decision cycle executed. 2 rules fired. ", and what
/// ended it before its time.
std::vector<std::string> RunLines(const kernel::Agent& agent, const RunCounts& before, const kernel::RunResult& run);

/// The pieces together.
std::string RunText(const kernel::Agent& agent, const RunCounts& before, const kernel::RunResult& run);

}  // namespace soarbox::cli
