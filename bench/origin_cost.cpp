// SPDX-License-Identifier: BSD-2-Clause
//
// Cost of noting origins in the kernel: for each element with o-support and each command, what created it.
//
//   origin_cost AGENT.soar DECISIONS on|off     runs the agent; 0: until it halts
//   origin_cost AGENT.soar TICKS on|off io      changes a percept in each tick, runs until output, completes the
//   command
//
// Prints one line of JSON. Only bench_run is measured: a profiler can count the instructions inside this function.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "peak_memory.h"
#include "sml_Client.h"
#include "soarbox_Inspection.h"

namespace {

void TickWithIo(sml::Agent& agent, sml::FloatElement& range, int tick) {
  agent.Update(&range, (tick * 7) % 40 + 0.5);
  agent.RunSelfTilOutput();
  for (int n = 0; n < agent.GetNumberCommands(); ++n) agent.GetCommand(n)->AddStatusComplete();
}

}  // namespace

extern "C" __attribute__((noinline)) void bench_run(sml::Agent* agent, sml::FloatElement* range, int length) {
  if (range != nullptr) {
    for (int tick = 1; tick <= length; ++tick) TickWithIo(*agent, *range, tick);
  } else if (length > 0) {
    agent->RunSelf(length);
  } else {
    agent->RunSelfForever();
  }
}

int main(int argc, char** argv) {
  const bool notes = argc >= 4 && std::strcmp(argv[3], "on") == 0;
  const bool has_io = argc == 5 && std::strcmp(argv[4], "io") == 0;
  if (argc < 4 || argc > 5 || (argc == 5 && !has_io) || (!notes && std::strcmp(argv[3], "off") != 0)) {
    std::fprintf(stderr, "usage: %s AGENT.soar DECISIONS on|off [io]\n", argv[0]);
    return 2;
  }
  sml::Kernel* const kernel = sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener);
  sml::Agent* const agent = kernel->CreateAgent("bench");
  agent->ExecuteCommandLine("watch 0");
  if (!agent->LoadProductions(argv[1], false)) {
    std::fprintf(stderr, "cannot load %s: %s\n", argv[1], agent->GetLastErrorDescription());
    return 1;
  }
  agent->ExecuteCommandLine("watch 0");
  if (notes && !soarbox::NoteOrigins(*agent)) {
    std::fprintf(stderr, "this kernel notes no origins\n");
    return 1;
  }
  sml::FloatElement* const range = has_io ? agent->CreateFloatWME(agent->GetInputLink(), "range", 100.0) : nullptr;
  const double before_mb = peak_rss_mb();
  const auto start = std::chrono::steady_clock::now();
  bench_run(agent, range, std::atoi(argv[2]));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf(
      "{\"agent\": \"%s\", \"origins\": \"%s\", \"decisions\": %d, \"seconds\": %.6f, \"peak_rss_mb\": %.1f, "
      "\"run_mb\": %.1f}\n",
      argv[1], notes ? "on" : "off", agent->GetDecisionCycleCounter(), seconds, peak_rss_mb(),
      peak_rss_mb() - before_mb);
  kernel->Shutdown();
  delete kernel;
  return 0;
}
