// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <cstdint>

#include "diagnostics/counted_allocations.h"
#include "sml_Client.h"

namespace {

TEST(ClientAllocation, ALoopOfInputRunAndCommandsAllocatesNothingInTheSteadyState) {
#ifdef SOARBOX_CHECK_INVARIANTS
  GTEST_SKIP() << "checking the invariants allocates";
#endif
  sml::Kernel* kernel = sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener);
  ASSERT_FALSE(kernel->HadError());
  sml::Agent* agent = kernel->CreateAgent("seeker");
  agent->ExecuteCommandLine("watch 0");
  for (const char* rule :
       {"sp {move (state <s> ^superstate nil ^io.input-link.range <r>) --> "
        "(<s> ^operator <o> + =) (<o> ^name move ^speed <r>)}",
        "sp {send (state <s> ^operator <o> ^io.output-link <out>) (<o> ^name move ^speed <v>) --> "
        "(<out> ^move <c>) (<c> ^speed <v>)}",
        "sp {done (state <s> ^operator.name ^io.output-link <out>) (<out> ^<name> <c>) (<c> ^status complete) --> "
        "(<out> ^<name> <c> -)}"}) {
    agent->ExecuteCommandLine(rule);
    ASSERT_TRUE(agent->GetLastCommandLineResult()) << rule;
  }
  sml::FloatElement* range = agent->GetInputLink()->CreateFloatWME("range", 0.5);
  std::uint64_t commands = 0;
  const auto tick = [&](int number) {
    agent->Update(range, number % 40 + 0.5);
    agent->RunSelfTilOutput();
    for (int n = 0; n < agent->GetNumberCommands(); ++n) {
      ++commands;
      agent->GetCommand(n)->AddStatusComplete();
    }
  };
  int number = 0;
  while (number < 5000) tick(number++);
  const std::uint64_t commands_before = commands;
  const std::int64_t before = soarbox::allocations::Count();
  while (number < 15000) tick(number++);
  EXPECT_EQ(soarbox::allocations::Count() - before, 0);
  EXPECT_GE(commands - commands_before, 8000u);
  kernel->Shutdown();
  delete kernel;
}

}  // namespace
