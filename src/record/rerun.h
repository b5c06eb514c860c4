// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/difference.h"
#include "record/tick_source.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::record {

/// A simulation that repeats a recorded run: the same scenario and seed, and the same inputs at the same ticks.
struct Rerun {
  std::unique_ptr<sim::Simulation> simulation;
  std::vector<Diagnostic> warnings;  ///< Another build made the recording, or files of the scenario have changed.
};

/// Which files to use if files of the scenario have changed since the recording.
enum class FilesFrom : std::uint8_t {
  kRecording,  ///< The files that the recording kept, if it kept any. The run can then always be repeated.
  kDisk,       ///< The present files, to find out what the changes do to the run.
};

struct RerunSettings {
  std::uint64_t last_tick = std::numeric_limits<std::uint64_t>::max();  ///< Later inputs are ignored.
  int threads = 0;                                                      ///< Number of threads for minds; 0: one per
                                                                        ///< core.
  FilesFrom files = FilesFrom::kRecording;
  bool origins = true;  ///< sim::SimulationSettings::records_origins.
};

/// Creates the simulation of a recording before its first tick, with the recorded inputs queued. Searches for its
/// scenario by name. Fails if it no longer exists or does not load. Warns if files have changed.
Result<Rerun> Restart(TickSource& recording, const sim::DataFolders& data, const RerunSettings& settings = {});
/// The same for a running world of this scenario, which was created with these settings.
Result<Rerun> Restart(TickSource& recording, const sim::Scenario& scenario, const sim::SimulationSettings& settings,
                      const RerunSettings& rerun);

/// Ticks per turn of the recorded game (sim::TurnTicks), from the files that the recording kept.
int TurnTicks(const Header& header);

/// Called with the tick that was reached, to show progress. Returns false to stop.
using Progress = std::function<bool(std::uint64_t tick)>;

/// The result of comparing a run with its recording.
struct Verdict {
  std::uint64_t first_tick = 0;  ///< The first compared tick; greater than 0 in a bounded recording.
  std::uint64_t last_tick = 0;
  bool interrupted = false;
  std::optional<Difference> difference;
  std::vector<Diagnostic> warnings;
};

/// Runs a recording again and compares each tick: state hash, bodies and minds. By default, uses the present files of
/// the scenario.
Result<Verdict> Verify(TickSource& recording, const sim::DataFolders& data, const Progress& progress = {},
                       int threads = 0, FilesFrom files = FilesFrom::kDisk);

/// Runs a recording again to the end of a tick, and checks the state hash there. Fails if the tick is not recorded, or
/// if the state differs; the message names the tick, the agent and the difference.
Result<Rerun> GoTo(TickSource& recording, std::uint64_t tick, const sim::DataFolders& data,
                   const Progress& progress = {}, int threads = 0);

}  // namespace soarbox::record
