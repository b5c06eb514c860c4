// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::kernel {

/// Counters for `stats`, since the agent was created or initialized (init-soar).
struct AgentCounters {
  std::uint64_t decision_phases = 0;  ///< The number in the trace's decision lines.
  std::uint64_t decision_cycles = 0;  ///< Output phases completed.
  std::uint64_t elaborations = 0;
  std::uint64_t inner_elaborations = 0;
  std::uint64_t pe_elaborations = 0;
  std::uint64_t firings = 0;
  std::uint64_t wme_additions = 0;
  std::uint64_t wme_removals = 0;
  std::uint64_t phases = 0;       ///< Number of samples of the working memory size: one after each phase.
  std::uint64_t wm_size_sum = 0;  ///< Sum of the samples: the mean is wm_size_sum / phases.
  std::uint64_t wm_size_maximum = 0;
  std::uint64_t justifications = 0;                              ///< Number created so far.
  std::uint64_t chunks = 0;                                      ///< Number learned so far.
  std::uint64_t max_wme_changes = 0, max_wme_changes_cycle = 0;  ///< Maximum of one decision cycle, and that cycle.
  std::uint64_t max_firings = 0, max_firings_cycle = 0;
  std::uint64_t inits = 0;  ///< Number of calls of init-soar, which does not reset it.
};

}  // namespace soarbox::kernel
