// SPDX-License-Identifier: BSD-2-Clause
//
// How many ticks per second the world makes, headless, with 1, 10, 100 and 1,000 agents, half Soar and half Lua.
//
//   world_ticks [AGENTS [SECONDS]]     without AGENTS: all four crowds; SECONDS are simulated (default 10)
//
// Prints one line of JSON per crowd.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "sim/scenario.h"
#include "sim/simulation.h"

namespace {

using Clock = std::chrono::steady_clock;

int Measure(int agents, double seconds) {
  const std::string root = SOARBOX_SOURCE_DIR;
  const soarbox::sim::DataFolders data{root + "/scenarios", root + "/media"};
  const auto scenario = soarbox::sim::FindScenario("crowd/crowd_" + std::to_string(agents) + ".lua", data);
  if (!scenario) {
    std::fputs(soarbox::Format(scenario.error()).c_str(), stderr);
    return 1;
  }
  const Clock::time_point begin = Clock::now();
  auto simulation = soarbox::sim::Simulation::Create(scenario.value(), {});
  if (!simulation) {
    std::fputs(soarbox::Format(simulation.error()).c_str(), stderr);
    return 1;
  }
  soarbox::sim::Simulation& world = **simulation;
  world.Tick();
  const Clock::time_point start = Clock::now();
  while (world.time_s() < seconds) world.Tick();
  const double run_s = std::chrono::duration<double>(Clock::now() - start).count();
  const double ticks = static_cast<double>(world.tick() - 1);
  std::printf(
      "{\"benchmark\": \"world_ticks\", \"agents\": %d, \"soar\": %zu, \"ticks\": %.0f, \"ticks_per_second\": %.1f, "
      "\"us_per_agent_tick\": %.2f, \"set_up_seconds\": %.3f, \"state\": \"%016llx\"}\n",
      agents, world.soar_agents(), ticks, ticks / run_s, run_s * 1e6 / (ticks * agents),
      std::chrono::duration<double>(start - begin).count(), static_cast<unsigned long long>(world.StateHash()));
  std::fflush(stdout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 2 ? std::atof(argv[2]) : 10;
  if (argc > 1) return Measure(std::atoi(argv[1]), seconds);
  for (const int agents : {1, 10, 100, 1000}) {
    if (const int status = Measure(agents, seconds); status != 0) return status;
  }
  return 0;
}
