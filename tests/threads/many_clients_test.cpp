// SPDX-License-Identifier: BSD-2-Clause
// Kernels on several threads, through the client API: each must behave as it does alone.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "sml_Client.h"

namespace {

using namespace sml;

constexpr int kTicks = 60;

constexpr const char* kRules[] = {
    ("sp {move (state <s> ^superstate nil ^io.input-link <in>) (<in> ^range <r> ^colour <c>) --> (<s> ^operator <o> + "
     "=) "
     "(<o> ^name move ^speed <r> ^colour <c>)}"),
    "sp {wait (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name wait)}",
    ("sp {send (state <s> ^operator <o> ^io.output-link <out>) (<o> ^name move ^speed <v> ^colour <c>) --> "
     "(<out> ^move <m>) (<m> ^speed <v> ^colour <c> ^luck (rand-int 100))}"),
    ("sp {done (state <s> ^operator.name ^io.output-link <out>) (<out> ^<name> <c>) (<c> ^status complete) --> "
     "(<out> ^<name> <c> -)}"),
};

void AppendText(smlPrintEventId, void* transcript, Agent*, char const* text) {
  *static_cast<std::string*>(transcript) += text;
}

/// Runs an agent for some ticks and returns all of its output, its commands and its final contents. `number` varies its
/// percepts.
std::string LifeOf(Kernel& kernel, const std::string& name, int number) {
  std::string transcript;
  Agent* agent = kernel.CreateAgent(name.c_str());
  const int printing = agent->RegisterForPrintEvent(smlEVENT_PRINT, AppendText, &transcript);
  for (const char* rule : kRules) transcript += agent->ExecuteCommandLine(rule);
  agent->ExecuteCommandLine("trace 4");
  FloatElement* range = agent->CreateFloatWME(agent->GetInputLink(), "range", number);
  StringElement* colour = agent->CreateStringWME(agent->GetInputLink(), "colour", "red");
  for (int tick = 0; tick < kTicks; ++tick) {
    agent->Update(range, number + 0.1 * tick);
    agent->Update(colour, tick % 3 == 0 ? "red" : "blue");
    agent->RunSelfTilOutput();
    for (int i = 0; i < agent->GetNumberCommands(); ++i) {
      Identifier* command = agent->GetCommand(i);
      transcript += std::string(command->GetCommandName()) + " " + command->GetParameterValue("speed") + " " +
                    command->GetParameterValue("luck") + "\n";
      command->AddStatusComplete();
    }
    agent->ClearOutputLinkChanges();
  }
  transcript += agent->ExecuteCommandLine("print --depth 10 --internal s1");
  transcript += agent->ExecuteCommandLine("production firing-counts");
  agent->UnregisterForPrintEvent(printing);
  kernel.DestroyAgent(agent);
  return transcript;
}

std::string LifeInAKernelOfItsOwn(bool in_new_thread, int number) {
  std::unique_ptr<Kernel> kernel(in_new_thread ? Kernel::CreateKernelInNewThread(Kernel::kSuppressListener)
                                               : Kernel::CreateKernelInCurrentThread(true, Kernel::kSuppressListener));
  std::string transcript = LifeOf(*kernel, "walker", number);
  kernel->Shutdown();
  return transcript;
}

std::vector<std::string> LivesAlone(int count) {
  std::vector<std::string> lives;
  for (int number = 0; number < count; ++number) lives.push_back(LifeInAKernelOfItsOwn(false, number));
  return lives;
}

TEST(ManyClients, KernelsOnThreadsOfTheirOwnRunAsTheyDoAlone) {
  constexpr int kThreads = 6;
  const std::vector<std::string> wanted = LivesAlone(kThreads);
  EXPECT_NE(wanted[0].find("move"), std::string::npos);
  for (const bool in_new_thread : {false, true}) {
    for (int repetition = 0; repetition < 3; ++repetition) {
      std::vector<std::string> lives(kThreads);
      std::vector<std::thread> threads;
      for (int n = 0; n < kThreads; ++n) {
        threads.emplace_back([&, n] { lives[n] = LifeInAKernelOfItsOwn(in_new_thread, n); });
      }
      for (std::thread& thread : threads) thread.join();
      EXPECT_EQ(lives, wanted);
    }
  }
}

}  // namespace
