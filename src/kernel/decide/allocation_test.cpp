// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>

#include "diagnostics/counted_allocations.h"
#include "kernel/agent.h"
#include "kernel/io/input_link.h"
#include "kernel/io/output_link.h"

namespace soarbox::kernel {
namespace {

void Load(Agent& agent, std::initializer_list<std::string_view> rules) {
  for (const std::string_view rule : rules) ASSERT_TRUE(agent.LoadProduction(rule).loaded) << rule;
}

TEST(Allocation, DecidingAndCountingAllocatesNothingInTheSteadyState) {
#ifdef SOARBOX_CHECK_INVARIANTS
  GTEST_SKIP() << "checking the invariants allocates";
#endif
  Agent agent("counter");
  Load(agent, {"begin (state <s> ^superstate nil -^turn) --> (<s> ^operator <o> + =) (<o> ^name begin)",
               "begun (state <s> ^operator.name begin) --> (<s> ^turn left ^steps 0)",
               "step (state <s> ^turn <t>) --> (<s> ^operator <o> + =) (<o> ^name step ^from <t>)",
               "idle (state <s> ^turn) --> (<s> ^operator <o> + <) (<o> ^name idle)",
               "left (state <s> ^operator.from left ^turn left ^steps <n>) --> "
               "(<s> ^turn left - right ^steps <n> - (+ <n> 1))",
               "right (state <s> ^operator.from right ^turn right ^steps <n>) --> "
               "(<s> ^turn right - left ^steps <n> - (+ <n> 1))"});
  agent.Run(RunUnit::kDecision, 5000);
  const std::int64_t before = allocations::Count();
  agent.Run(RunUnit::kDecision, 5000);
  EXPECT_EQ(allocations::Count() - before, 0);
  EXPECT_EQ(agent.counters().decision_cycles, 9999u);
  const Symbol steps = agent.memory().ValueOf(agent.goals().top().id, agent.mutable_symbols().String("steps"));
  EXPECT_EQ(agent.symbols().IntegerValue(steps), 9998);
}

TEST(Allocation, AnAgentThatNeverComesToRestTakesNoMoreMemory) {
  Agent agent("restless");
  Load(agent, {"make (state <s> ^superstate nil -^n) --> (<s> ^n 0 ^room <r>) (<r> ^name hall)",
               "propose (state <s> ^superstate nil ^n <n>) --> (<s> ^operator <o> +) (<o> ^name step ^at <n>)"});
  agent.Run(RunUnit::kDecision, 100);
  const std::size_t elements = agent.memory().wmes().size(), identifiers = agent.memory().identifier_limit();
  agent.Run(RunUnit::kDecision, 400);
  EXPECT_EQ(agent.counters().decision_cycles, 499u);
  EXPECT_EQ(agent.memory().wmes().size(), elements);
  EXPECT_LE(agent.memory().identifier_limit(), identifiers + 256);
}

TEST(Allocation, PerceivingDecidingAndActingAllocatesNothingInTheSteadyState) {
#ifdef SOARBOX_CHECK_INVARIANTS
  GTEST_SKIP() << "checking the invariants allocates";
#endif
  Agent agent("seeker");
  Load(agent, {"move (state <s> ^superstate nil ^io.input-link.range <r>) --> "
               "(<s> ^operator <o> + =) (<o> ^name move ^speed <r>)",
               "send (state <s> ^operator <o> ^io.output-link <out>) (<o> ^name move ^speed <v>) --> "
               "(<out> ^move <c>) (<c> ^speed <v>)",
               "done (state <s> ^operator.name ^io.output-link <out>) (<out> ^<name> <c>) (<c> ^status complete) --> "
               "(<out> ^<name> <c> -)"});
  const InputElement range = agent.input().Add(InputObject::kInputLink, "range", 0.5);
  std::uint64_t commands = 0;
  const auto tick = [&](int number) {
    agent.input().Update(range, number % 40 + 0.5);
    agent.Step(RunUnit::kOutput);
    for (const OutputCommand& command : agent.output().new_commands()) {
      ++commands;
      agent.input().Add(agent.input().ObjectFor(command.identifier), "status", std::string_view("complete"));
    }
  };
  int number = 0;
  while (number < 5000) tick(number++);
  const std::uint64_t commands_before = commands;
  const std::int64_t before = allocations::Count();
  while (number < 10000) tick(number++);
  EXPECT_EQ(allocations::Count() - before, 0);
  EXPECT_GE(commands - commands_before, 4000u);
}

}  // namespace
}  // namespace soarbox::kernel
