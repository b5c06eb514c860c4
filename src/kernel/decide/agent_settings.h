// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "kernel/observer.h"
#include "kernel/rules/soar_version.h"

namespace soarbox::kernel {

/// What `soar` sets. Changes hold from the next phase on.
struct AgentSettings {
  int max_elaborations = 100;  ///< Per phase.
  int max_goal_depth = 23;
  int max_nil_output_cycles = 15;
  std::int64_t max_decision_time_us = 0;  ///< 0: unlimited.
  int max_gp = 20000;
  /// If a rule needs more partial matches than this, its agent breaks down: see Agent::out_of_memory(). A partial match
  /// takes 64 bytes; what is made of it takes several times as much.
  std::uint32_t max_partial_matches = 8'000'000;
  /// An agent whose own memory grows beyond this while it runs breaks down, too. The host sets it, no command does.
  std::size_t most_memory_bytes = std::numeric_limits<std::size_t>::max();
  /// When the counter of firings (Counters::firings) has reached this number, each phase ends as if it had reached
  /// max_elaborations. The host sets it; no command does.
  std::uint64_t most_firings = std::numeric_limits<std::uint64_t>::max();
  bool keep_all_top_o_preferences = false;
  bool wait_snc = false;
  /// On: a match that both elaborates and applies an operator gets i-support, and a warning says so. Off: o-support.
  bool warn_of_mixed_support = true;
  /// A rule whose only action is a numeric preference duplicates one that differs from it in the number only.
  bool ignore_numbers_of_duplicates = true;
  SoarVersion like = SoarVersion::k965;  ///< Rules that are loaded earlier keep the meaning that they had.
  Phase stop_phase = Phase::kApply;      ///< `run -d` stops before this phase.
};

}  // namespace soarbox::kernel
