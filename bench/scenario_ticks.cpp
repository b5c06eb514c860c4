// SPDX-License-Identifier: BSD-2-Clause
//
// Speed of a scenario, headless.
//
//   scenario_ticks SCENARIO [SECONDS [THREADS [WARM]]]     SECONDS are simulated (default 10); THREADS for the minds
//                                                          (default: one per core); WARM seconds before are not
//                                                          measured
//
// Prints one line of JSON. On a busy machine, use the CPU times: that of all threads, and that of the thread that runs
// the world, because no run can be faster than that thread.

#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "sim/scenario.h"
#include "sim/simulation.h"

namespace {

double CpuSeconds(int whose) {
  rusage used{};
  getrusage(whose, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// A separate function, so that valgrind can count its instructions.
[[gnu::noinline]] void MeasuredTicks(soarbox::sim::Simulation& world, double seconds) {
  for (const double end_s = world.time_s() + seconds; world.time_s() < end_s;) {
    world.Tick();
    world.TakeEvents();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: scenario_ticks SCENARIO [SECONDS [THREADS [WARM]]]\n", stderr);
    return 2;
  }
  const double seconds = argc > 2 ? std::atof(argv[2]) : 10;
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = soarbox::sim::FindScenario(argv[1], {root + "/scenarios", root + "/media"});
  if (!scenario) {
    std::fputs(soarbox::Format(scenario.error()).c_str(), stderr);
    return 1;
  }
  soarbox::sim::SimulationSettings settings;
  settings.soar.threads = argc > 3 ? std::atoi(argv[3]) : 0;
  auto simulation = soarbox::sim::Simulation::Create(scenario.value(), settings);
  if (!simulation) {
    std::fputs(soarbox::Format(simulation.error()).c_str(), stderr);
    return 1;
  }
  soarbox::sim::Simulation& world = **simulation;
  for (const double warm_s = argc > 4 ? std::atof(argv[4]) : 0; world.time_s() < warm_s;) {
    world.Tick();
    world.TakeEvents();
  }
  const double set_up_s = CpuSeconds(RUSAGE_SELF), own_before_s = CpuSeconds(RUSAGE_THREAD);
  const auto start = std::chrono::steady_clock::now();
  MeasuredTicks(world, seconds);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double cpu_s = CpuSeconds(RUSAGE_SELF) - set_up_s, own_s = CpuSeconds(RUSAGE_THREAD) - own_before_s;
  const soarbox::sim::TickCosts& costs = world.costs();
  std::printf(
      "{\"benchmark\": \"scenario_ticks\", \"scenario\": \"%s\", \"soar\": %zu, \"seconds\": %.2f, "
      "\"wall_seconds\": %.3f, \"cpu_seconds\": %.3f, \"world_thread_cpu_seconds\": %.3f, \"set_up_cpu_seconds\": "
      "%.3f, "
      "\"wall_by_part\": {\"events\": %.3f, \"decide\": %.3f, \"act\": %.3f, \"move\": %.3f, \"rest\": %.3f}, "
      "\"state\": \"%016llx\"}\n",
      argv[1], world.soar_agents(), seconds, wall_s, cpu_s, own_s, set_up_s, costs.events_s, costs.decide_s,
      costs.act_s, costs.move_s, costs.rest_s, static_cast<unsigned long long>(world.StateHash()));
  return 0;
}
