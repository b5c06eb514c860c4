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

/// A recorded run, run again: the same scenario and seed, and the same inputs at the same ticks.
struct Rerun {
  std::unique_ptr<sim::Simulation> simulation;
  std::vector<Diagnostic> warnings;  ///< Another build made the recording; the scenario's files have changed.
};

/// Which files a run is made from if files of its scenario have changed since.
enum class FilesFrom : std::uint8_t {
  kRecording,  ///< The files as they were then, if they were kept: the run can always continue.
  kDisk,       ///< The files as they are now: shows what the changes do to the run.
};

struct RerunSettings {
  std::uint64_t last_tick = std::numeric_limits<std::uint64_t>::max();  ///< Later inputs are left out.
  int threads = 0;                                                      ///< For the minds; 0: one per core.
  FilesFrom files = FilesFrom::kRecording;
};

/// Makes the simulation of a recording as it was before its first tick, with the recorded inputs queued. Searches for
/// its scenario again, by name. Fails if it no longer exists or does not load. Warns if files have changed.
Result<Rerun> Restart(TickSource& recording, const sim::DataFolders& data, const RerunSettings& settings = {});
/// The same for a running world of this scenario, made with these settings.
Result<Rerun> Restart(TickSource& recording, const sim::Scenario& scenario, const sim::SimulationSettings& settings,
                      const RerunSettings& rerun);

/// The ticks per turn of the recorded game (sim::TurnTicks), from the files that the recording keeps.
int TurnTicks(const Header& header);

/// Called with the tick reached, to show progress; false stops the work.
using Progress = std::function<bool(std::uint64_t tick)>;

/// The result of comparing a run with its recording.
struct Verdict {
  std::uint64_t first_tick = 0;  ///< The first tick compared: a bounded recording does not start at tick 0.
  std::uint64_t last_tick = 0;
  bool interrupted = false;
  std::optional<Difference> difference;
  std::vector<Diagnostic> warnings;
};

/// Runs a recording again and compares each tick: state hash, bodies and minds. Uses the current files of the scenario
/// unless told otherwise.
Result<Verdict> Verify(TickSource& recording, const sim::DataFolders& data, const Progress& progress = {},
                       int threads = 0, FilesFrom files = FilesFrom::kDisk);

/// Runs a recording again up to the end of a tick, and checks the state hash there. Fails if the tick is not recorded,
/// or if the run reached another state (the message names the tick, the agent and the difference).
Result<Rerun> GoTo(TickSource& recording, std::uint64_t tick, const sim::DataFolders& data,
                   const Progress& progress = {}, int threads = 0);

}  // namespace soarbox::record
