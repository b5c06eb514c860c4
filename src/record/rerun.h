// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/reader.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::record {

/// A recorded run, run again: the same scenario and seed, and the same inputs at the same ticks.
struct Rerun {
  std::unique_ptr<sim::Simulation> simulation;
  std::vector<Diagnostic> warnings;  ///< Another build made the recording; the scenario's files have changed.
};

/// Makes the simulation as it was before its first tick, with the recorded inputs waiting, up to those of `last_tick`.
/// Fails if the scenario is no longer there or does not load.
Result<Rerun> Restart(Reader& recording, const sim::DataFolders& data,
                      std::uint64_t last_tick = std::numeric_limits<std::uint64_t>::max());

/// Where a run that was simulated again goes another way than its recording.
struct Difference {
  std::uint64_t tick = 0;
  std::string agent;     ///< The first body that differs; empty if none does.
  std::string element;   ///< What differs first: "position", "inputs", "the state's hash", ...
  std::string recorded;  ///< Its value in the recording, and ...
  std::string now;       ///< ... what it is now.
};

/// Told the tick that was reached, for showing progress; false ends the work.
using Progress = std::function<bool(std::uint64_t tick)>;

/// What came of comparing a run with its recording.
struct Verdict {
  std::uint64_t first_tick = 0;  ///< Compared from here on: a bounded recording does not begin with tick 0.
  std::uint64_t last_tick = 0;
  bool interrupted = false;
  std::optional<Difference> difference;
  std::vector<Diagnostic> warnings;
};

/// Runs a recording again and compares each tick: state hash, bodies, events and minds.
Result<Verdict> Verify(Reader& recording, const sim::DataFolders& data, const Progress& progress = {});

/// The first thing in which two records of one tick differ, bodies first; none if they are equal in all that both hold.
std::optional<Difference> FirstDifference(const TickRecord& recorded, const TickRecord& now);

/// Runs a recording again up to the end of a tick, with its hash checked there. Fails if the tick is not recorded, or
/// if the run has come to another state (the message names the tick, the agent and what differs).
Result<Rerun> GoTo(Reader& recording, std::uint64_t tick, const sim::DataFolders& data, const Progress& progress = {});

}  // namespace soarbox::record
