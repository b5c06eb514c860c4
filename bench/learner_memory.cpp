// SPDX-License-Identifier: BSD-2-Clause
//
// Memory of agents that learn, next to others with the same file: the KB that each of them adds when it learns some
// rules, and when it runs for the same time without learning.
//
//   learner_memory FILE.soar [AGENTS [RULES...]]     defaults: 100 agents that learn 10 and 100 rules
//
// FILE is learning-scale.soar, with or without other rules (`generate.py` writes learners-311 and learners-3011). A
// task is three decisions, and the agent learns a rule for each task. Prints one line of JSON for each number of rules.
// Shared pages are counted proportionally (the kernel's Pss). Only the public SML client interface is used, so the same
// source builds against any library that offers it.

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "sml_Client.h"

namespace {

constexpr int kDecisionsPerRule = 3;

double ProportionalKilobytes() {
  double kilobytes = 0;
  if (std::FILE* file = std::fopen("/proc/self/smaps_rollup", "r")) {
    char line[256];
    while (std::fgets(line, sizeof line, file) != nullptr && std::sscanf(line, "Pss: %lf", &kilobytes) != 1) {
    }
    std::fclose(file);
  }
  return kilobytes;
}

int LearnedRules(sml::Agent& agent) {
  const char* names = agent.ExecuteCommandLine("print --chunks");
  int count = 0;
  for (const char* at = std::strstr(names, "chunk"); at != nullptr; at = std::strstr(at, "chunk")) {
    ++count;
    at = std::strchr(at, '\n');
    if (at == nullptr) break;
  }
  return count;
}

struct Cost {
  double made, added;
  int learned;
};

/// Creates the agents, starts them, and runs them for the decisions that this number of rules needs.
Cost Measure(const char* file, int agents, int rules, bool learning) {
  sml::Kernel* const kernel = sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener);
  const double before = ProportionalKilobytes();
  std::vector<sml::Agent*> all;
  for (int n = 0; n < agents; ++n) {
    sml::Agent* const agent = kernel->CreateAgent(("agent" + std::to_string(n)).c_str());
    agent->ExecuteCommandLine("watch 0");
    if (!agent->LoadProductions(file, false)) {
      std::fprintf(stderr, "learner_memory: cannot load %s: %s\n", file, agent->GetLastErrorDescription());
      std::exit(1);
    }
    agent->ExecuteCommandLine("chunk never");
    agent->RunSelf(2 * kDecisionsPerRule);
    agent->ExecuteCommandLine(learning ? "chunk always" : "chunk never");
    agent->ExecuteCommandLine("chunk max-chunks 1000000");
    all.push_back(agent);
  }
  const double made = ProportionalKilobytes();
  for (sml::Agent* agent : all) agent->RunSelf(rules * kDecisionsPerRule);
  const double after = ProportionalKilobytes();
  return {(made - before) / agents, (after - made) / agents, LearnedRules(*all.back())};
}

/// Measures in a separate process, because memory that another measurement freed would be used first.
Cost MeasureApart(const char* file, int agents, int rules, bool learning) {
  int ends[2];
  if (pipe(ends) != 0) std::exit(1);
  const pid_t child = fork();
  if (child == 0) {
    const Cost cost = Measure(file, agents, rules, learning);
    const bool written = write(ends[1], &cost, sizeof cost) == static_cast<ssize_t>(sizeof cost);
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  Cost cost{};
  const bool read_all = child > 0 && read(ends[0], &cost, sizeof cost) == static_cast<ssize_t>(sizeof cost);
  close(ends[0]);
  int status = 0;
  if (child > 0) waitpid(child, &status, 0);
  if (!read_all || status != 0) std::exit(1);
  return cost;
}

}  // namespace

int main(int argc, char** argv) {
  const int agents = argc > 2 ? std::atoi(argv[2]) : 100;
  if (argc < 2 || agents < 1) {
    std::fprintf(stderr, "usage: %s FILE.soar [AGENTS [RULES...]]\n", argv[0]);
    return 2;
  }
  std::vector<int> counts;
  for (int n = 3; n < argc; ++n) counts.push_back(std::atoi(argv[n]));
  if (counts.empty()) counts = {10, 100};
  for (const int rules : counts) {
    const Cost learning = MeasureApart(argv[1], agents, rules, true);
    const Cost running = MeasureApart(argv[1], agents, rules, false);
    std::printf(
        "{\"agents\": %d, \"made_kb\": %.0f, \"learned_rules\": %d, \"learning_adds_kb\": %.0f, "
        "\"running_adds_kb\": %.0f}\n",
        agents, learning.made, learning.learned, learning.added, running.added);
    std::fflush(stdout);
  }
  return 0;
}
