// SPDX-License-Identifier: BSD-2-Clause
//
// The loop of a program that hosts many agents: change one input value of each,
// run it until it acts, read the command and mark it complete.
//
//   io_loop N TICKS MODE [AGENT.soar]
//
// MODE  self        run each agent separately, kernel in this thread
//       all         change all inputs, then run all agents together
//       new-thread  like self, but with the kernel in a separate thread
//
// AGENT.soar defaults to agents/io-seeker.soar next to the program or in the
// working directory. Prints one line of JSON. One tick runs before the measured
// ones, so that set-up is not counted.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "peak_memory.h"
#include "sml_Client.h"

namespace {

struct Host {
  sml::Kernel* kernel = nullptr;
  std::vector<sml::Agent*> agents;
  std::vector<sml::FloatElement*> ranges;
  long commands = 0;
  long advances = 0;

  double reading(int tick, std::size_t i) const {
    return static_cast<double>((tick * 7 + static_cast<int>(i) * 13) % 40) + 0.5;
  }

  void collect(sml::Agent* agent) {
    const int count = agent->GetNumberCommands();
    for (int c = 0; c < count; ++c) {
      sml::Identifier* command = agent->GetCommand(c);
      const char* name = command->GetCommandName();
      if (name[0] == 'a') ++advances;
      command->AddStatusComplete();
      ++commands;
    }
  }

  void tick_self(int tick) {
    for (std::size_t i = 0; i < agents.size(); ++i) {
      agents[i]->Update(ranges[i], reading(tick, i));
      agents[i]->RunSelfTilOutput();
      collect(agents[i]);
    }
  }

  void tick_all(int tick) {
    for (std::size_t i = 0; i < agents.size(); ++i) agents[i]->Update(ranges[i], reading(tick, i));
    kernel->RunAllTilOutput();
    for (sml::Agent* agent : agents) collect(agent);
  }
};

bool readable(const std::string& path) {
  if (std::FILE* f = std::fopen(path.c_str(), "r")) {
    std::fclose(f);
    return true;
  }
  return false;
}

}  // namespace

extern "C" __attribute__((noinline)) void bench_run(void* opaque, int first, int ticks, int all) {
  Host& host = *static_cast<Host*>(opaque);
  for (int t = first; t < first + ticks; ++t) {
    if (all)
      host.tick_all(t);
    else
      host.tick_self(t);
  }
}

int main(int argc, char** argv) {
  const bool known = argc >= 4 && (!std::strcmp(argv[3], "self") || !std::strcmp(argv[3], "all") ||
                                   !std::strcmp(argv[3], "new-thread"));
  if (!known || argc > 5) {
    std::fprintf(stderr, "usage: %s N TICKS self|all|new-thread [AGENT.soar]\n", argv[0]);
    return 2;
  }
  const int n = std::atoi(argv[1]);
  const int ticks = std::atoi(argv[2]);
  const std::string mode = argv[3];

  std::string path = "agents/io-seeker.soar";
  if (argc == 5)
    path = argv[4];
  else if (!readable(path)) {
    std::string self(argv[0]);
    const auto slash = self.find_last_of('/');
    path = (slash == std::string::npos ? std::string() : self.substr(0, slash + 1)) + "agents/io-seeker.soar";
  }

  Host host;
  host.kernel = mode == "new-thread" ? sml::Kernel::CreateKernelInNewThread(sml::Kernel::kSuppressListener)
                                     : sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener);
  if (host.kernel->HadError()) {
    std::fprintf(stderr, "%s\n", host.kernel->GetLastErrorDescription());
    return 1;
  }
  for (int i = 0; i < n; ++i) {
    sml::Agent* agent = host.kernel->CreateAgent(("seeker" + std::to_string(i)).c_str());
    agent->ExecuteCommandLine("watch 0");
    if (!agent->LoadProductions(path.c_str(), false)) {
      std::fprintf(stderr, "cannot load %s\n", path.c_str());
      return 1;
    }
    agent->ExecuteCommandLine("watch 0");
    host.ranges.push_back(agent->CreateFloatWME(agent->GetInputLink(), "range", 100.0));
    host.agents.push_back(agent);
  }

  const int all = mode == "all";
  const int warm_up = 1;
  for (int t = 0; t < warm_up; ++t) {
    if (all)
      host.tick_all(t);
    else
      host.tick_self(t);
  }
  host.commands = host.advances = 0;

  const std::clock_t cpu_start = std::clock();
  const auto start = std::chrono::steady_clock::now();
  bench_run(&host, warm_up, ticks, all);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;

  std::printf(
      "{\"agent\": \"io_loop\", \"n\": %d, \"ticks\": %d, \"mode\": \"%s\", \"commands\": %ld, \"advances\": %ld, "
      "\"seconds\": %.6f, \"cpu_seconds\": %.6f, \"us_per_agent_tick\": %.3f, \"peak_rss_mb\": %.1f}\n",
      n, ticks, mode.c_str(), host.commands, host.advances, seconds, cpu_seconds,
      seconds * 1e6 / (static_cast<double>(n) * ticks), peak_rss_mb());

  host.kernel->Shutdown();
  delete host.kernel;
  return 0;
}
