// SPDX-License-Identifier: BSD-2-Clause
//
// Cost of 10,000 learned rules: tasks and decisions per second before, while and after an agent learns them, and with
// tasks for which none of them matches; memory per rule.
//
//   learning_scale agents/learning-scale.soar
//
// Only the public SML client interface is used, so the same source builds against any library that offers it. The
// phases are functions with C names, so that an instruction-counting profiler can be restricted to one of them.

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>

#include "sml_Client.h"

#ifdef __linux__
#include <unistd.h>
#endif

namespace {

constexpr double kTasks = 10000;

double resident_mb() {
#ifdef __linux__
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
#else
  return 0;
#endif
}

int learned_rules(sml::Agent* agent) {
  const std::string names = agent->ExecuteCommandLine("print --chunks");
  int count = 0;
  for (std::size_t at = names.find("chunk"); at != std::string::npos; at = names.find("chunk", at)) {
    ++count;
    at = names.find('\n', at);
    if (at == std::string::npos) break;
  }
  return count;
}

/// Runs the agent through its tasks, which must end with (halt), and prints a line. A separate function, so that a
/// profiler can count its instructions.
template <typename Run>
void measure(sml::Agent* agent, const char* phase, Run run) {
  const double before = resident_mb();
  const int decisions_before = agent->GetDecisionCycleCounter();
  const std::clock_t start = std::clock();
  run(agent);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const int decisions = agent->GetDecisionCycleCounter() - decisions_before;
  const double after = resident_mb();
  if (agent->GetRunState() != sml::sml_RUNSTATE_HALTED)
    std::fprintf(stderr, "%s: the tasks were not finished\n", phase);
  std::printf(
      "{\"phase\": \"%s\", \"decisions\": %d, \"cpu_seconds\": %.3f, \"decisions_per_second\": %.0f, "
      "\"tasks_per_second\": %.0f, \"learned_rules\": %d, \"resident_mb\": %.1f, \"grown_mb\": %.1f}\n",
      phase, decisions, seconds, decisions / seconds, kTasks / seconds, learned_rules(agent), after, after - before);
  std::fflush(stdout);
  agent->InitSoar();
}

}  // namespace

extern "C" {

__attribute__((noinline)) void scale_before(sml::Agent* agent) {
  agent->RunSelfForever();
}
__attribute__((noinline)) void scale_learning(sml::Agent* agent) {
  agent->RunSelfForever();
}
__attribute__((noinline)) void scale_after(sml::Agent* agent) {
  agent->RunSelfForever();
}
__attribute__((noinline)) void scale_other_tasks(sml::Agent* agent) {
  agent->RunSelfForever();
}

}  // extern "C"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s AGENT.soar\n", argv[0]);
    return 2;
  }
  sml::Kernel* kernel = sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener);
  sml::Agent* agent = kernel->CreateAgent("scale");
  if (!agent->LoadProductions(argv[1], false)) {
    std::fprintf(stderr, "cannot load %s: %s\n", argv[1], agent->GetLastErrorDescription());
    return 1;
  }
  agent->ExecuteCommandLine("watch 0");
  agent->ExecuteCommandLine("chunk never");
  measure(agent, "before", scale_before);
  agent->ExecuteCommandLine("chunk always");
  agent->ExecuteCommandLine("chunk max-chunks 1000000");
  measure(agent, "learning", scale_learning);
  agent->ExecuteCommandLine("chunk never");
  measure(agent, "after", scale_after);
  agent->ExecuteCommandLine("sp {scale*first (state <s> ^superstate nil) --> (<s> ^first 1000)}");
  measure(agent, "other tasks", scale_other_tasks);
  kernel->Shutdown();
  delete kernel;
  return 0;
}
