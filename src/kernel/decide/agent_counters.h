// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::kernel {

/// Counted since the agent was made or initialised (init-soar), for `stats`. Plain numbers; reading is free.
struct AgentCounters {
  std::uint64_t decision_phases = 0;  ///< The number in the trace's decision lines.
  std::uint64_t decision_cycles = 0;  ///< Output phases completed.
  std::uint64_t elaborations = 0;
  std::uint64_t inner_elaborations = 0;
  std::uint64_t pe_elaborations = 0;
  std::uint64_t firings = 0;
  std::uint64_t wme_additions = 0;
  std::uint64_t wme_removals = 0;
  std::uint64_t phases = 0;       ///< Samples of the working memory size: one after each phase.
  std::uint64_t wm_size_sum = 0;  ///< Sum of the samples: the mean is wm_size_sum / phases.
  std::uint64_t wm_size_maximum = 0;
  std::uint64_t justifications = 0;                              ///< Made so far.
  std::uint64_t chunks = 0;                                      ///< Learned so far.
  std::uint64_t max_wme_changes = 0, max_wme_changes_cycle = 0;  ///< Of one decision cycle.
  std::uint64_t max_firings = 0, max_firings_cycle = 0;
  std::uint64_t inits = 0;  ///< How often init-soar ran. Not reset by it.
};

}  // namespace soarbox::kernel
