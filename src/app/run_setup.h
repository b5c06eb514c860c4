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

/// A run that is ready to begin, with everything that its session refers to. It stays where it is.
struct RunSetup {
  RunSetup() = default;
  RunSetup(const RunSetup&) = delete;
  RunSetup& operator=(const RunSetup&) = delete;

  RunOptions options;  ///< As given, completed from the scenario's file.
  sim::DataFolders data;
  sim::Scenario scenario;
  sim::SimulationSettings settings;
  std::optional<RunSession> session;
  record::Header header;
  std::optional<RunRecordings> recordings;
};

/// Sets up what `soarbox run` was asked for. Returns kOk and the run, or prints what is wrong and returns another
/// ExitCode.
int SetUpRun(const RunOptions& options, std::unique_ptr<RunSetup>& result);

}  // namespace soarbox::app
