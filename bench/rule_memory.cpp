// SPDX-License-Identifier: BSD-2-Clause
//
// Memory of rules: the additional memory of the first agent with these rules, compared with an agent without rules, and
// the memory of each further agent with the same rules, which agents share.
//
//   rule_memory FILE.soar [AGENTS]     creates this number of agents with the rules (default 11)
//
// Prints one line of JSON. Counts the memory that the C library's allocator has returned.

#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "sml_Client.h"

namespace {

double HeapMegabytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / (1024.0 * 1024.0);
}

/// Creates an agent, lets it decide once (rules are shared when a run begins) and returns its memory.
double CostOfAgent(sml::Kernel& kernel, const std::string& name, const char* rules) {
  const double before = HeapMegabytes();
  sml::Agent* const agent = kernel.CreateAgent(name.c_str());
  agent->ExecuteCommandLine("watch 0");
  if (rules != nullptr && !agent->LoadProductions(rules, false)) {
    std::fprintf(stderr, "rule_memory: cannot load %s: %s\n", rules, agent->GetLastErrorDescription());
    std::exit(1);
  }
  agent->RunSelf(1);
  return HeapMegabytes() - before;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: %s FILE.soar [AGENTS]\n", argv[0]);
    return 2;
  }
  const int agents = argc == 3 ? std::atoi(argv[2]) : 11;
  if (agents < 2) {
    std::fprintf(stderr, "rule_memory: at least two agents are needed to share rules\n");
    return 2;
  }
  sml::Kernel* const kernel = sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener);
  CostOfAgent(*kernel, "warm-up", nullptr);
  const double empty = CostOfAgent(*kernel, "empty", nullptr);
  const double first = CostOfAgent(*kernel, "first", argv[1]) - empty;
  double further = 0;
  for (int n = 1; n < agents; ++n) {
    further += CostOfAgent(*kernel, "agent" + std::to_string(n), argv[1]) - empty;
  }
  further /= agents - 1;
  std::printf("{\"agents\": %d, \"empty_agent_mb\": %.3f, \"first_mb\": %.3f, \"further_mb\": %.3f, \"share\": %.4f}\n",
              agents, empty, first, further, further / first);
  kernel->Shutdown();
  delete kernel;
  return 0;
}
