// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>

#include "record/history.h"
#include "record/recorder.h"
#include "sim/simulation.h"

namespace soarbox::record {

/// For tests: the folders of the project's scenarios and media.
inline sim::DataFolders Data() {
  const std::string root = SOARBOX_SOURCE_DIR;
  return {root + "/scenarios", root + "/media"};
}

/// For tests: a run with its history, as a window has one. Set its members, then call Note for tick 0.
struct NotedRun {
  void Note() {
    TickRecord record;
    Observe(*simulation, simulation->TakeEvents(), Level::kDecisions, record);
    history->Add(record);
  }
  void Run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      simulation->Tick();
      Note();
    }
  }

  sim::Scenario scenario;
  sim::SimulationSettings settings;
  std::unique_ptr<sim::Simulation> simulation;
  std::unique_ptr<History> history;
};

}  // namespace soarbox::record
