// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "diagnostics/diagnostic.h"
#include "workbench/live_run.h"
#include "workbench/surroundings.h"
#include "workbench/time_machine.h"

namespace soarbox::workbench {

/// Data that all parts of a desk use.
struct DeskCommon {
  LiveRun* run = nullptr;  ///< Null for a recording.
  TimeMachine& past;
  Surroundings& surroundings;
  std::function<void(Diagnostic, std::string agent)> note_problem;
  /// Call it when the run uses a changed file without errors: its earlier problems are over.
  std::function<void(const std::string& file)> forget_problems;

  /// The simulation of the live run; null for a recording.
  sim::Simulation* Live() const { return run == nullptr ? nullptr : &run->simulation(); }
  /// The simulation of the tick that is shown: the live one or the rebuilt past; null while the past is not rebuilt.
  sim::Simulation* Looked() const { return past.is_live() ? Live() : past.rebuilt().world(); }
};

}  // namespace soarbox::workbench
