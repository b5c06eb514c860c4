// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/base/ids.h"
#include "kernel/base/symbol_table.h"
#include "kernel/match/rete.h"
#include "kernel/memory/wme.h"
#include "kernel/observer.h"
#include "kernel/rules/production.h"

/// The face of the library. cli/ and sml/ use this header (and the headers of the parts that it hands out for
/// reading); nothing else of the program includes kernel/ at all.
namespace soarbox::kernel {

struct AgentSettings {
  int max_elaborations = 100;         ///< Per phase.
  int max_goal_depth = 100;
  int max_nil_output_cycles = 15;
  std::int64_t max_decision_time_us = 0;  ///< 0: unlimited.
  int max_gp = 20000;
  bool keep_all_top_o_preferences = false;
  bool wait_snc = false;
  Phase stop_phase = Phase::kApply;   ///< `run -d` stops before this phase.
};

enum class RunUnit : std::uint8_t { kElaboration, kPhase, kDecision, kOutput, kForever };
enum class StopReason : std::uint8_t { kCompleted, kInterrupted, kHalted, kLimit };

struct RunResult {
  StopReason reason = StopReason::kCompleted;
  std::uint64_t decisions = 0;        ///< Decision cycles completed by this run.
  std::uint64_t elaborations = 0;
  std::uint64_t firings = 0;
};

}  // namespace soarbox::kernel
