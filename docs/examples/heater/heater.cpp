// SPDX-License-Identifier: BSD-2-Clause
//
// A simulation of one's own with a Soar agent in it: percepts in, one step of the mind, commands out, and back.

#include <cstdio>
#include <cstring>

#include "sml_Client.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: heater RULES\n");
    return 2;
  }
  sml::Kernel* kernel = sml::Kernel::CreateKernelInNewThread();
  if (kernel->HadError()) {
    std::fprintf(stderr, "%s\n", kernel->GetLastErrorDescription());
    return 1;
  }
  sml::Agent* agent = kernel->CreateAgent("heater");
  if (!agent->LoadProductions(argv[1])) {
    std::fprintf(stderr, "%s\n", agent->GetLastErrorDescription());
    return 1;
  }

  // The world, and what the agent perceives of it: two attributes of its input link.
  double temperature = 17;
  bool heating = false;
  sml::Identifier* input = agent->GetInputLink();
  sml::FloatElement* felt = agent->CreateFloatWME(input, "temperature", temperature);
  sml::StringElement* seen = agent->CreateStringWME(input, "heating", "no");

  // From now on a command counts as new only once.
  agent->SetOutputLinkChangeTracking(true);
  for (int minute = 0; minute < 60; ++minute) {
    temperature += heating ? 0.4 : -0.2;
    agent->Update(felt, temperature);
    agent->Update(seen, heating ? "yes" : "no");

    // The mind decides until it says something, 15 times at most: a world never waits for it.
    agent->RunSelfTilOutput();

    for (int i = 0; i < agent->GetNumberCommands(); ++i) {
      sml::Identifier* command = agent->GetCommand(i);
      const char* to = command->GetParameterValue("to");
      if (std::strcmp(command->GetCommandName(), "heat") != 0 || to == nullptr) {
        command->AddStatusError();
        continue;
      }
      heating = std::strcmp(to, "on") == 0;
      std::printf("minute %d, %.1f degrees: heating %s\n", minute, temperature, to);
      command->AddStatusComplete();
    }
    agent->ClearOutputLinkChanges();
  }
  kernel->Shutdown();
  delete kernel;
  return 0;
}
