// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "diagnostics/result.h"
#include "mission/testing.h"

namespace soarbox::app {

/// A mission and its outcome.
struct TestedMission {
  std::filesystem::path file;
  mission::LoadedMission loaded;
  mission::MissionOutcome outcome;
};

/// Writes the results in JUnit's format for continuous integration: a suite for each mission, with a case for each
/// check over all seeds.
Result<void> WriteJunit(const std::filesystem::path& file, const std::vector<TestedMission>& tested);

/// Whether a check passed in all runs.
bool CheckPassed(const TestedMission& tested, std::size_t check);

}  // namespace soarbox::app
