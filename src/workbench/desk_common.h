// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>

#include "diagnostics/diagnostic.h"
#include "workbench/live_run.h"
#include "workbench/surroundings.h"
#include "workbench/time_machine.h"

namespace soarbox::workbench {

/// What all parts of a desk use.
struct DeskCommon {
  LiveRun* run = nullptr;  ///< Null: a recording.
  TimeMachine& past;
  Surroundings& surroundings;
  std::function<void(Diagnostic, std::string agent)> note_problem;

  /// The run that is under way; null for a recording.
  sim::Simulation* Live() const { return run == nullptr ? nullptr : &run->simulation(); }
  /// The world that is looked into: the live one, or the rebuilt past; null while that is not there.
  sim::Simulation* Looked() const { return past.is_live() ? Live() : past.rebuilt().world(); }
};

}  // namespace soarbox::workbench
