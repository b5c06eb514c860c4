// SPDX-License-Identifier: BSD-2-Clause
//
// The loop of a program that hosts agents, in its own process or through a kernel in another one: a new percept for
// each agent, a run until it acts, its commands read and marked complete.
//
//   sml_host_loop RULES AGENTS TICKS [ADDRESS PORT]
//
// Prints a line per command: tick, agent, name, speed, time tag.
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "sml_Client.h"

int main(int argc, char** argv) {
  if (argc != 4 && argc != 6) {
    std::fputs("usage: sml_host_loop RULES AGENTS TICKS [ADDRESS PORT]\n", stderr);
    return 2;
  }
  const bool remote = argc == 6;
  const std::unique_ptr<sml::Kernel> kernel(
      remote ? sml::Kernel::CreateRemoteConnection(true, argv[4], std::atoi(argv[5]))
             : sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener));
  struct Body {
    sml::Agent* agent;
    sml::FloatElement* range;
  };
  std::vector<Body> bodies;
  for (int i = 0; i < std::atoi(argv[2]) && !kernel->HadError(); ++i) {
    sml::Agent* agent = kernel->CreateAgent(("seeker" + std::to_string(i)).c_str());
    if (!agent || !agent->LoadProductions(argv[1])) break;
    bodies.push_back({agent, agent->CreateFloatWME(agent->GetInputLink(), "range", 100.0)});
  }
  if (kernel->HadError() || bodies.size() != static_cast<std::size_t>(std::atoi(argv[2]))) {
    std::fprintf(stderr, "sml_host_loop: %s\n", kernel->GetLastErrorDescription());
    return 1;
  }
  for (int tick = 0; tick < std::atoi(argv[3]); ++tick) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      sml::Agent* agent = bodies[i].agent;
      agent->Update(bodies[i].range, (tick * 7 + static_cast<int>(i) * 13) % 40 + 0.5);
      agent->RunSelfTilOutput();
      for (int n = 0; n < agent->GetNumberCommands(); ++n) {
        sml::Identifier* command = agent->GetCommand(n);
        std::printf("%d %s %s %s %lld\n", tick, agent->GetAgentName(), command->GetCommandName(),
                    command->GetParameterValue("speed"), command->GetTimeTag());
        command->AddStatusComplete();
      }
    }
  }
  for (const Body& body : bodies) kernel->DestroyAgent(body.agent);
  kernel->Shutdown();
  return 0;
}
