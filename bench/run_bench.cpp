// SPDX-License-Identifier: BSD-2-Clause
//
// Loads one agent, runs it silently and prints one line of JSON.
//
//   run_bench AGENT.soar [DECISIONS [ROUNDS]]
//
// Without DECISIONS, or with 0, the agent runs until it halts. With ROUNDS it is
// initialised (init-soar) afterwards and run again, for this total number of runs. The
// figures are then the sums of all runs and initialisations. Only the public SML client
// interface is used, so the same source builds against any library that offers it.
//
// The phases are separate functions with C names, so that an instruction-counting
// profiler can be restricted to one of them.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

#include "peak_memory.h"
#include "sml_Client.h"

namespace {

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string agent_name(const char* path) {
  std::string name(path);
  if (auto slash = name.find_last_of("/\\"); slash != std::string::npos) name.erase(0, slash + 1);
  if (auto dot = name.rfind('.'); dot != std::string::npos) name.erase(dot);
  return name;
}

}  // namespace

extern "C" {

__attribute__((noinline)) bool bench_load(sml::Agent* agent, const char* path) {
  return agent->LoadProductions(path, false);
}

__attribute__((noinline)) void bench_run(sml::Agent* agent, int decisions) {
  if (decisions > 0)
    agent->RunSelf(decisions);
  else
    agent->RunSelfForever();
}

__attribute__((noinline)) void bench_init(sml::Agent* agent) {
  agent->InitSoar();
}

}  // extern "C"

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    std::fprintf(stderr, "usage: %s AGENT.soar [DECISIONS [ROUNDS]]\n", argv[0]);
    return 2;
  }
  const int limit = argc >= 3 ? std::atoi(argv[2]) : 0;
  const int rounds = argc == 4 ? std::atoi(argv[3]) : 1;

  sml::Kernel* kernel = sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener);
  if (kernel->HadError()) {
    std::fprintf(stderr, "%s\n", kernel->GetLastErrorDescription());
    return 1;
  }
  sml::Agent* agent = kernel->CreateAgent("bench");
  agent->ExecuteCommandLine("watch 0");

  auto start = std::chrono::steady_clock::now();
  const bool loaded = bench_load(agent, argv[1]);
  const double load_seconds = since(start);
  if (!loaded) {
    std::fprintf(stderr, "cannot load %s: %s\n", argv[1], agent->GetLastErrorDescription());
    return 1;
  }
  agent->ExecuteCommandLine("watch 0");

  int before = agent->GetDecisionCycleCounter();
  int decisions = 0;
  double init_seconds = 0;
  const std::clock_t cpu_start = std::clock();
  start = std::chrono::steady_clock::now();
  for (int round = 1;; ++round) {
    bench_run(agent, limit);
    decisions += agent->GetDecisionCycleCounter() - before;
    if (round >= rounds) break;
    const auto init_start = std::chrono::steady_clock::now();
    bench_init(agent);
    init_seconds += since(init_start);
    before = agent->GetDecisionCycleCounter();
  }
  const double run_seconds = since(start);
  const double cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
  const bool halted = agent->GetRunState() == sml::sml_RUNSTATE_HALTED;

  std::printf(
      "{\"agent\": \"%s\", \"decisions\": %d, \"halted\": %s, \"seconds\": %.6f, "
      "\"cpu_seconds\": %.6f, \"us_per_decision\": %.3f, \"peak_rss_mb\": %.1f, \"load_seconds\": %.6f",
      agent_name(argv[1]).c_str(), decisions, halted ? "true" : "false", run_seconds, cpu_seconds,
      decisions > 0 ? run_seconds * 1e6 / decisions : 0.0, peak_rss_mb(), load_seconds);
  if (rounds > 1) std::printf(", \"rounds\": %d, \"init_seconds\": %.6f", rounds, init_seconds);
  std::printf("}\n");

  kernel->Shutdown();
  delete kernel;
  return 0;
}
