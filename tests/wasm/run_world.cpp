// SPDX-License-Identifier: BSD-2-Clause
// Runs a world like `soarbox run WORLD --headless --json --seconds S` and prints the last line of its output, which
// contains the hash of the final state. It needs a third of the command's modules, so it compiles sooner.
//
//   run_world WORLD SECONDS      the folders scenarios/ and media/ are those of SOARBOX_DATA
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "sim/scenario.h"
#include "sim/scenario_file.h"
#include "sim/simulation.h"
#include "world/world.h"

using namespace soarbox;

int main(int argc, char** argv) {
  const char* const data = std::getenv("SOARBOX_DATA");
  if (argc != 3 || data == nullptr) {
    std::cerr << "usage: SOARBOX_DATA=FOLDER run_world WORLD SECONDS\n";
    return 2;
  }
  const double seconds = std::atof(argv[2]);
  const std::filesystem::path root = data;
  const Result<sim::Scenario> scenario = sim::FindScenario(argv[1], {root / "scenarios", root / "media"});
  if (!scenario) {
    std::cerr << Format(scenario.error());
    return 1;
  }
  sim::SimulationSettings settings;
  settings.soar.threads = 1;
  settings.soar.port = 0;
  settings.limits.memory_bytes = std::size_t{2048} << 20;
  if (!scenario->definition.empty()) {
    const Result<sim::ScenarioFile> file = sim::ReadScenarioFile(scenario->definition);
    if (!file) {
      std::cerr << Format(file.error());
      return 1;
    }
    settings.seed = file->seed.value_or(1);
  }
  Result<std::unique_ptr<sim::Simulation>> made = sim::Simulation::Create(*scenario, settings);
  if (!made) {
    std::cerr << Format(made.error());
    return 1;
  }
  sim::Simulation& simulation = **made;
  while (simulation.time_s() < seconds && !simulation.HasEnded()) {
    simulation.Tick();
    simulation.TakeEvents();
  }
  simulation.Finish();
  std::printf("{\"event\":\"end\",\"ticks\":%" PRIu64 ",\"state\":\"%016" PRIx64 "\"}\n", simulation.tick(),
              simulation.StateHash());
  return 0;
}
