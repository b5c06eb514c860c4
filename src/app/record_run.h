// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>

#include "app/run_options.h"
#include "app/run_session.h"
#include "record/header.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::app {

/// A run is recorded if the user asks for it; one in a window always, unless told otherwise.
bool WantsRecording(const RunOptions& options);

/// Starts recording a run that has made no tick yet: into the file named, or into the usual one, which is bounded. If
/// it cannot be written that is told. Returns a remark on where it goes, or nothing if there is no recording.
std::string RecordRun(RunSession& session, const RunOptions& options, const sim::Scenario& scenario,
                      const sim::SimulationSettings& settings, record::Level level);

/// Where a run that begins again is recorded if the user named a file: "fight-2.soarrec" beside "fight.soarrec", with
/// the first number that no file has, so that what was recorded stays.
std::filesystem::path NextRecording(const std::filesystem::path& file);

}  // namespace soarbox::app
