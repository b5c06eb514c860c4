// SPDX-License-Identifier: BSD-2-Clause
//
// Ticks per second of the world, headless, with 1 to 10,000 agents, half Soar and half Lua; times of the parts of a
// tick, and memory.
//
//   world_ticks [AGENTS [SECONDS [THREADS]]]
//
// Without AGENTS: all crowds. SECONDS are simulated (default 10; for 10,000 agents 1). THREADS for the minds (default:
// one per core). Prints one line of JSON per crowd. On a busy machine, use the CPU times of all threads and of the
// thread that runs the world: on idle cores a tick would take as long as the latter.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "sim/scenario.h"
#include "sim/simulation.h"

namespace {

using Clock = std::chrono::steady_clock;

/// Processor time of all threads of this process, or of the calling thread; it depends little on the load of the
/// machine.
double CpuSeconds(int whose = RUSAGE_SELF) {
  rusage used{};
  getrusage(whose, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

double PeakMegabytes() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024;
}

/// The measured function; count_ticks.py counts its instructions.
[[gnu::noinline]] void MeasuredTicks(soarbox::sim::Simulation& world, double until_s) {
  while (world.time_s() < until_s) world.Tick();
}

int Measure(int agents, double seconds, int threads) {
  const std::string root = SOARBOX_SOURCE_DIR;
  const soarbox::sim::DataFolders data{root + "/scenarios", root + "/media"};
  const auto scenario = soarbox::sim::FindScenario("crowd/crowd_" + std::to_string(agents) + ".lua", data);
  if (!scenario) {
    std::fputs(soarbox::Format(scenario.error()).c_str(), stderr);
    return 1;
  }
  soarbox::sim::SimulationSettings settings;
  settings.soar.threads = threads;
  const double empty_mb = PeakMegabytes();
  const Clock::time_point begin = Clock::now();
  auto simulation = soarbox::sim::Simulation::Create(scenario.value(), settings);
  if (!simulation) {
    std::fputs(soarbox::Format(simulation.error()).c_str(), stderr);
    return 1;
  }
  soarbox::sim::Simulation& world = **simulation;
  // A crowd without rules, or with failing scripts, measures nothing.
  for (const soarbox::sim::RunEvent& event : world.TakeEvents()) {
    if (event.diagnostic.message.empty()) continue;
    std::fputs(soarbox::Format(event.diagnostic).c_str(), stderr);
    return 1;
  }
  const double set_up_cpu_s = CpuSeconds();
  world.Tick();
  const soarbox::sim::TickCosts before = world.costs();
  const double cpu_before_s = CpuSeconds(), own_before_s = CpuSeconds(RUSAGE_THREAD);
  const Clock::time_point start = Clock::now();
  MeasuredTicks(world, seconds);
  const double run_s = std::chrono::duration<double>(Clock::now() - start).count();
  const double ticks = static_cast<double>(world.tick() - 1);
  const soarbox::sim::TickCosts& after = world.costs();
  const double cpu_s = CpuSeconds() - cpu_before_s, own_s = CpuSeconds(RUSAGE_THREAD) - own_before_s;
  const double peak_mb = PeakMegabytes();
  const auto us = [&](double first, double last) { return (last - first) * 1e6 / ticks; };
  std::printf(
      "{\"benchmark\": \"world_ticks\", \"agents\": %d, \"soar\": %zu, \"ticks\": %.0f, \"ticks_per_second\": %.1f, "
      "\"us_per_agent_tick\": %.2f, \"tick_us\": {\"events\": %.1f, \"decide\": %.1f, \"act\": %.1f, \"move\": %.1f, "
      "\"rest\": %.1f}, \"cpu_ms_per_tick\": %.3f, \"world_thread_cpu_ms_per_tick\": %.3f, \"set_up_seconds\": %.3f, "
      "\"set_up_cpu_seconds\": %.3f, "
      "\"peak_mb\": %.1f, \"kb_per_agent\": %.0f, \"state\": \"%016llx\"}\n",
      agents, world.soar_agents(), ticks, ticks / run_s, run_s * 1e6 / (ticks * agents),
      us(before.events_s, after.events_s), us(before.decide_s, after.decide_s), us(before.act_s, after.act_s),
      us(before.move_s, after.move_s), us(before.rest_s, after.rest_s), cpu_s * 1e3 / ticks, own_s * 1e3 / ticks,
      std::chrono::duration<double>(start - begin).count(), set_up_cpu_s, peak_mb, (peak_mb - empty_mb) * 1024 / agents,
      static_cast<unsigned long long>(world.StateHash()));
  std::fflush(stdout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 2 ? std::atof(argv[2]) : 10;
  const int threads = argc > 3 ? std::atoi(argv[3]) : 0;
  if (argc > 1) return Measure(std::atoi(argv[1]), seconds, threads);
  for (const int agents : {1, 10, 100, 1000, 10000}) {
    // Each crowd runs in a separate process, so that its peak memory is measured separately.
    const pid_t child = fork();
    if (child == 0) return Measure(agents, agents < 10000 ? seconds : 1, threads);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) < 0 || status != 0) return 1;
  }
  return 0;
}
