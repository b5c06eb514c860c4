// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>
#include <malloc.h>

#include <memory>
#include <string>
#include <vector>

#include "kernel/agent.h"

namespace soarbox::kernel {
namespace {

/// What the C library's allocator has handed out; 0 where another one is in its place (sanitizers).
std::size_t HeapBytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

std::string RuleBody(int number) {
  const std::string n = std::to_string(number);
  return "rule*" + n + " (state <s> ^superstate nil ^task task-" + n + " ^world <w>) (<w> ^object <x> ^limit-" + n +
         " <limit>) (<x> ^size { <z> < <limit> } ^colour colour-" + n + ") -(<x> ^hidden yes) --> " +
         "(<s> ^operator <o> + =) (<o> ^name op-" + n + " ^object <x> ^size (+ <z> " + n + "))";
}

std::size_t CostOfAgent(std::vector<std::unique_ptr<Agent>>& agents, int rules) {
  const std::size_t before = HeapBytes();
  agents.push_back(std::make_unique<Agent>("agent" + std::to_string(agents.size())));
  for (int n = 0; n < rules; ++n) EXPECT_TRUE(agents.back()->LoadProduction(RuleBody(n)).loaded);
  agents.back()->Run(RunUnit::kDecision, 1);
  return HeapBytes() - before;
}

TEST(RuleSharing, AFurtherAgentWithTheSameRulesCostsAFractionOfTheFirst) {
  constexpr int kRules = 1000;
  std::vector<std::unique_ptr<Agent>> agents;
  agents.reserve(16);
  CostOfAgent(agents, 0);  // What the process makes once.
  const std::size_t empty = CostOfAgent(agents, 0);
  if (empty == 0) GTEST_SKIP() << "this build has another allocator";
  const std::size_t first = CostOfAgent(agents, kRules) - empty;
  std::size_t further = 0;
  for (int n = 0; n < 10; ++n) further += CostOfAgent(agents, kRules) - empty;
  further /= 10;
  RecordProperty("first", std::to_string(first));
  RecordProperty("further", std::to_string(further));
  // The nodes' own state is most of it: 32 bytes each.
  EXPECT_LT(further * 3, first) << "first " << first << ", further " << further;
}

}  // namespace
}  // namespace soarbox::kernel
