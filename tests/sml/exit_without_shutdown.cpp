// SPDX-License-Identifier: BSD-2-Clause
// Three kernels with threads and ports, and a program that exits without shutting them down.
#include "sml_Client.h"

int main() {
  for (int i = 0; i < 3; ++i) {
    sml::Kernel* kernel = sml::Kernel::CreateKernelInNewThread(sml::Kernel::kUseAnyPort);
    if (kernel->HadError()) return 1;
    sml::Agent* agent = kernel->CreateAgent("agent");
    agent->CreateFloatWME(agent->GetInputLink(), "distance", 0);
    agent->RunSelfTilOutput();
  }
  return 0;
}
