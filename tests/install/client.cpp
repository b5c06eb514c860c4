// SPDX-License-Identifier: BSD-2-Clause
//
// A client as a user would write it: one agent, one percept, one command. Prints the command's name.

#include <cstdio>

#include "sml_Client.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  sml::Kernel* kernel = sml::Kernel::CreateKernelInNewThread(sml::Kernel::kSuppressListener);
  if (kernel->HadError()) {
    std::fprintf(stderr, "%s\n", kernel->GetLastErrorDescription());
    return 1;
  }
  sml::Agent* agent = kernel->CreateAgent("walker");
  if (!agent->LoadProductions(argv[1])) {
    std::fprintf(stderr, "%s\n", agent->GetLastErrorDescription());
    return 1;
  }
  agent->CreateFloatWME(agent->GetInputLink(), "distance", 100.0);
  agent->RunSelfTilOutput();
  for (int i = 0; i < agent->GetNumberCommands(); ++i) {
    std::puts(agent->GetCommand(i)->GetCommandName());
    agent->GetCommand(i)->AddStatusComplete();
  }
  kernel->Shutdown();
  delete kernel;
  return 0;
}
