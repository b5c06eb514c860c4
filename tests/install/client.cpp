// SPDX-License-Identifier: BSD-2-Clause
//
// A client as users write it: one agent, one percept, one command. Prints the command's name.

#include <cstdio>

#include "misc.h"
#include "portability.h"
#include "sml_Client.h"
#include "sml_Names.h"
#include "sml_Utils.h"
#include "soarversion.h"
#include "thread_Event.h"
#include "thread_Lock.h"
#include "thread_Thread.h"

namespace {

/// The functions of the small headers that clients use, in a separate thread: 0 if all of them work.
class Helpers : public soar_thread::Thread {
 public:
  void Run() override {
    soar_thread::Mutex mutex;
    const soar_thread::Lock lock(&mutex);
    std::string text;
    char buffer[TO_C_STRING_BUFSIZE];
    int number = 0;
    long counter = 0;
    ok = to_string(2.5, text) == "2.5" && from_string(number, "12 and more") && number == 12 &&
         std::string(to_c_string(-7, buffer)) == "-7" && atomic_inc(&counter) == 1 &&
         std::string(sml::sml_Names::kCommand_CreateAgent) == "create_agent" &&
         std::string(VERSION_STRING()) == sml::sml_Names::kSoarVersionValue;
    done.TriggerEvent();
  }
  bool ok = false;
  soar_thread::Event done;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  Helpers helpers;
  helpers.Start();
  if (!helpers.done.WaitForEvent(10, 0) || !helpers.ok) {
    std::fprintf(stderr, "the helpers do not work\n");
    return 1;
  }
  helpers.Stop(true);
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
