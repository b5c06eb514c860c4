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

/// Missions below a folder, or the one that a file or the name of a scenario means: mission.toml, and scenario files
/// with [[check]]. In the order of their names; a folder without any gives none.
std::vector<std::filesystem::path> FindMissionFiles(const std::filesystem::path& path, const sim::DataFolders& data);

/// The file with the checks of this scenario: its own, or the mission.toml beside it; empty: there are none.
std::filesystem::path MissionFileOf(const sim::Scenario& scenario);

/// Reads a mission and looks up its names. What is wrong is added to the problems; then nothing is to be run.
LoadedMission LoadMission(const std::filesystem::path& file, const sim::DataFolders& data,
                          std::vector<Diagnostic>& problems);

struct TestSettings {
  int jobs = 0;                      ///< Processes at a time; 0: one per processor.
  std::vector<std::uint64_t> seeds;  ///< Instead of the missions' own; empty: those.
  bool empty_minds = false;
  bool ends_endless = false;   ///< Runs in which rules fire without end are ended.
  bool errors_fail = false;    ///< RunSpec::errors_fail.
  std::filesystem::path keep;  ///< Folder for recordings of runs that fail; empty: none are kept.
  AccountSettings account;     ///< What runs that fail are to say of a file of rules.
};

/// What came of all runs of a mission.
struct MissionOutcome {
  std::vector<RunResult> runs;  ///< In the order of the seeds; those that were interrupted are left out.
  std::size_t needed = 0;       ///< So many must pass.
  std::size_t passed = 0;
  std::size_t asked = 0;                ///< So many were to be made; more than `runs` if it was interrupted.
  std::vector<std::size_t> check_true;  ///< For each check: in how many runs it was.
  double wall_s = 0;
  bool Passed(const Mission& mission) const;
  bool HasBroken() const;  ///< A run crashed, hung or is undecided.
  bool IsRefused() const;
  bool IsInterrupted() const { return runs.size() < asked; }
  /// Interrupted, and no run that was made failed: nobody knows how it would have ended.
  bool IsOpen(const Mission& mission) const;
};

/// In how many of so many runs this check must be true.
std::size_t NeededOf(const Mission& mission, const MissionOutcome& outcome, std::size_t check);

/// The seeds that a mission is tested with: the settings', its own, or 1.
std::vector<std::uint64_t> SeedsOf(const Mission& mission, const TestSettings& settings);

/// Runs a mission with all its seeds, each run in a process of its own. `on_run` is called as they end, `goes_on` now
/// and then; false ends it.
Result<MissionOutcome> TestMission(const LoadedMission& loaded, const TestSettings& settings,
                                   const std::function<void(const RunResult&)>& on_run,
                                   const std::function<bool()>& goes_on);

/// The limits of one run.
ChildLimits LimitsOf(const LoadedMission& loaded, int jobs);
/// What a child handed over, or how it ended without.
RunResult ResultOf(const ChildEnd& end, std::uint64_t seed, const ChildLimits& limits);

/// Where recordings of runs that failed are kept: $XDG_STATE_HOME/soarbox/test, by default below ~/.local/state; empty
/// without a home.
std::filesystem::path StateFolder(std::string_view what);

}  // namespace soarbox::mission
