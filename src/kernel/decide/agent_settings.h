// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "kernel/observer.h"
#include "kernel/rules/soar_version.h"

namespace soarbox::kernel {

/// The settings of the `soar` command. Changes take effect in the next phase.
struct AgentSettings {
  int max_elaborations = 100;  ///< Per phase.
  int max_goal_depth = 23;
  int max_nil_output_cycles = 15;
  std::int64_t max_decision_time_us = 0;  ///< In microseconds; 0: unlimited.
  int max_gp = 20000;
  /// If all rules together have more partial matches, the agent breaks down: see Agent::out_of_memory(). A partial
  /// match needs 64 bytes; the resulting instantiations need several times as much.
  std::uint32_t max_partial_matches = 8'000'000;
  /// If an agent's own memory exceeds this number of bytes while it runs, it breaks down, too. Set by the host, not by
  /// a command.
  std::size_t most_memory_bytes = std::numeric_limits<std::size_t>::max();
  /// Maximum of AgentCounters::firings. When it is reached, each phase ends as if it had reached max_elaborations. Set
  /// by the host, not by a command.
  std::uint64_t most_firings = std::numeric_limits<std::uint64_t>::max();
  bool keep_all_top_o_preferences = false;
  bool wait_snc = false;
  /// Support of a match that both elaborates and applies an operator. On: i-support, with a warning. Off: o-support.
  bool warn_of_mixed_support = true;
  /// A rule whose only action is a numeric preference is a duplicate of a rule that differs only in the number.
  bool ignore_numbers_of_duplicates = true;
  SoarVersion like = SoarVersion::k965;  ///< Affects only rules that are loaded later.
  Phase stop_phase = Phase::kApply;      ///< `run -d` stops before this phase.
};

}  // namespace soarbox::kernel
