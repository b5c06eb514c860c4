// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "mission/child_pool.h"
#include "mission/mission.h"
#include "mission/run_mission.h"
#include "sim/scenario.h"

namespace soarbox::mission {

/// A mission that is ready to run.
struct LoadedMission {
  Mission mission;
  sim::Scenario scenario;
  double seconds = 60;
};

/// Finds missions below a folder, or the one that a file or the name of a scenario refers to: mission.toml, and
/// scenario files with [[check]]. Sorted by name; empty if the folder contains none.
std::vector<std::filesystem::path> FindMissionFiles(const std::filesystem::path& path, const sim::DataFolders& data);

/// The file with the checks of this scenario: its own file, or mission.toml in its folder; empty if there is none.
std::filesystem::path MissionFileOf(const sim::Scenario& scenario);

/// Reads a mission and checks its names. Adds errors to `problems`; the mission must not be run then.
LoadedMission LoadMission(const std::filesystem::path& file, const sim::DataFolders& data,
                          std::vector<Diagnostic>& problems);

struct TestSettings {
  int jobs = 0;                      ///< Number of processes at a time; 0: one per processor.
  std::vector<std::uint64_t> seeds;  ///< Replace the seeds of the missions; empty: use those.
  bool empty_minds = false;
  bool ends_endless = false;   ///< End runs in which rules fire endlessly.
  bool errors_fail = false;    ///< RunSpec::errors_fail.
  std::filesystem::path keep;  ///< Folder for recordings of failed runs; empty: they are not kept.
  AccountSettings account;     ///< Requests an account of a file of rules from failed runs.
};

/// The results of all runs of a mission.
struct MissionOutcome {
  std::vector<RunResult> runs;  ///< In the order of the seeds, without those that were interrupted.
  std::size_t needed = 0;       ///< Number of runs that must pass.
  std::size_t passed = 0;
  std::size_t asked = 0;                ///< Number of requested runs; more than `runs` if it was interrupted.
  std::vector<std::size_t> check_true;  ///< For each check: number of runs in which it was true.
  double wall_s = 0;
  bool Passed(const Mission& mission) const;
  bool HasBroken() const;  ///< A run crashed, hung or is undecided.
  bool IsRefused() const;
  bool IsInterrupted() const { return runs.size() < asked; }
  /// Whether it was interrupted and no finished run failed, so that the result is not known.
  bool IsOpen(const Mission& mission) const;
};

/// The number of runs in which this check must be true.
std::size_t NeededOf(const Mission& mission, const MissionOutcome& outcome, std::size_t check);

/// The seeds for testing a mission: those of the settings, else its own, else 1.
std::vector<std::uint64_t> SeedsOf(const Mission& mission, const TestSettings& settings);

/// Runs a mission with all its seeds, each run in a separate process. Calls `on_run` when a run ends, and `goes_on`
/// periodically; if that returns false, testing ends.
Result<MissionOutcome> TestMission(const LoadedMission& loaded, const TestSettings& settings,
                                   const std::function<void(const RunResult&)>& on_run,
                                   const std::function<bool()>& goes_on);

/// The limits of one run.
ChildLimits LimitsOf(const LoadedMission& loaded, int jobs);
/// Converts the output of a child, or how it ended without output, to a result.
RunResult ResultOf(const ChildEnd& end, std::uint64_t seed, const ChildLimits& limits);

/// The folder for recordings of failed runs: $XDG_STATE_HOME/soarbox/test, by default ~/.local/state/soarbox/test;
/// empty without a home directory.
std::filesystem::path StateFolder(std::string_view what);

}  // namespace soarbox::mission
