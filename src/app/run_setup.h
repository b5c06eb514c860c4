// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <optional>

#include "app/record_run.h"
#include "app/run_options.h"
#include "app/run_session.h"
#include "record/header.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::app {

/// A run that is ready to begin, with all objects to which its session refers. It must not be moved.
struct RunSetup {
  RunSetup() = default;
  RunSetup(const RunSetup&) = delete;
  RunSetup& operator=(const RunSetup&) = delete;

  RunOptions options;  ///< As given, with defaults from the scenario's file.
  sim::DataFolders data;
  sim::Scenario scenario;
  sim::SimulationSettings settings;
  std::optional<RunSession> session;
  record::Header header;
  std::optional<RunRecordings> recordings;
};

/// Prepares a run with these options. Returns kOk and the run, or prints the error and returns another ExitCode.
int SetUpRun(const RunOptions& options, std::unique_ptr<RunSetup>& result);

}  // namespace soarbox::app
