// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>
#include <malloc.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "kernel/agent.h"

namespace soarbox::kernel {
namespace {

/// Bytes allocated from the C library; 0 if another allocator is in use (sanitizers).
std::size_t HeapBytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// This process's share of its memory pages; 0 if the system does not report it.
std::size_t PageBytes() {
  std::ifstream file("/proc/self/smaps_rollup");
  std::string word;
  std::size_t kilobytes = 0;
  while (file >> word) {
    if (word == "Pss:" && file >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

/// Rules of four kinds: a proposal, an application, a comparison, and an elaboration with a negation.
std::string RuleBody(int number) {
  const std::string n = std::to_string(number);
  const std::string many = std::to_string(number % 499);
  const std::string few = std::to_string(number % 29);
  const std::string head = "rule*" + n + " (state <s> ";
  switch (number % 4) {
    case 0:
      return head + "^task task-" + many + " ^mode mode-" + few + ") --> (<s> ^operator <o> + =) (<o> ^name op-" + n +
             " ^code " + n + ")";
    case 1:
      return head + "^operator <o> ^world <w>) (<o> ^name op-" + many + ") (<w> ^object <x> ^limit-" + many +
             " <limit>) (<x> ^size { <z> < <limit> } ^colour colour-" + few + ") --> (<x> ^size <z> - (+ <z> " + n +
             ") ^marked-by op-" + n + ")";
    case 2:
      return head + "^operator <o> + ^operator <p> +) (<o> ^name op-" + many + " ^cost <c>) (<p> ^name op-" + few +
             " ^cost > <c>) --> (<s> ^operator <o> > <p>)";
    default:
      return head + "^world <w>) (<w> ^object <x> ^object { <y> <> <x> }) (<x> ^kind kind-" + many +
             " ^at-row <r>) (<y> ^kind kind-" + few + " ^at-row > <r>) -(<x> ^hidden yes) --> (<x> ^above-" + n +
             " <y>)";
  }
}

std::size_t CostOfAgent(std::vector<std::unique_ptr<Agent>>& agents, int rules, bool perceives = false) {
  const std::size_t before = HeapBytes();
  agents.push_back(std::make_unique<Agent>("agent" + std::to_string(agents.size())));
  for (int n = 0; n < rules; ++n) EXPECT_TRUE(agents.back()->LoadProduction(RuleBody(n)).loaded);
  if (perceives) {
    agents.back()->input().Add(InputObject::kInputLink, "seen-" + std::to_string(agents.size()), 0.5);
  }
  agents.back()->Run(RunUnit::kDecision, 1);
  return HeapBytes() - before;
}

TEST(RuleSharing, AFurtherAgentWithTheSameRulesCostsAFractionOfTheFirst) {
  constexpr int kRules = 6000;
  constexpr int kFurther = 4;
  std::vector<std::unique_ptr<Agent>> agents;
  agents.reserve(16);
  CostOfAgent(agents, 0);  // Allocations that the process makes only once.
  const std::size_t empty = CostOfAgent(agents, 0);
  if (empty == 0) GTEST_SKIP() << "this build has another allocator";
  const std::size_t first = CostOfAgent(agents, kRules) - empty;
  std::size_t further = 0;
  for (int n = 0; n < kFurther; ++n) further += CostOfAgent(agents, kRules) - empty;
  further /= kFurther;
  RecordProperty("first", std::to_string(first));
  RecordProperty("further", std::to_string(further));
  // Most of it is the state of the nodes: 18 bytes per node.
  EXPECT_LE(further * 10, first) << "first " << first << ", further " << further;
}

TEST(RuleSharing, AnAgentThatPerceivesBeforeItsFirstDecisionSharesToo) {
  constexpr int kRules = 2000;
  std::vector<std::unique_ptr<Agent>> agents;
  agents.reserve(16);
  CostOfAgent(agents, 0, true);
  const std::size_t empty = CostOfAgent(agents, 0, true);
  if (empty == 0) GTEST_SKIP() << "this build has another allocator";
  const std::size_t first = CostOfAgent(agents, kRules, true) - empty;
  const std::size_t further = CostOfAgent(agents, kRules, true) - empty;
  EXPECT_LE(further * 5, first) << "first " << first << ", further " << further;
  EXPECT_EQ(agents[2]->rete().NetworkDigest(), agents[3]->rete().NetworkDigest());
}

TEST(RuleSharing, ARuleOfItsOwnCostsAnAgentAFractionOfTheSharedOnes) {
  constexpr int kRules = 6000;
  constexpr std::size_t kAgents = 12;
  std::vector<std::unique_ptr<Agent>> agents;
  agents.reserve(kAgents + 1);
  if (CostOfAgent(agents, 0) == 0 || PageBytes() == 0) GTEST_SKIP() << "this build has another allocator";
  while (agents.size() < kAgents) CostOfAgent(agents, kRules);
  const std::size_t network = agents.back()->rete().NetworkBytes();
  const auto add = [&](std::size_t agent) {
    EXPECT_TRUE(agents[agent]->LoadProduction(RuleBody(kRules + static_cast<int>(agent))).loaded);
  };
  add(1);  // Creates the data that the others share.
  const std::size_t before = PageBytes();
  for (std::size_t n = 2; n < kAgents; ++n) add(n);
  const std::size_t each = (PageBytes() - before) / (kAgents - 2);
  RecordProperty("network", std::to_string(network));
  RecordProperty("each", std::to_string(each));
  EXPECT_LE(each * 3, network) << "network " << network << ", each " << each;
  for (std::size_t n = 1; n < kAgents; ++n) {
    agents[n]->Excise(agents[n]->FindProduction("rule*" + std::to_string(n)));
    agents[n]->Run(RunUnit::kDecision, 1);
    EXPECT_EQ(agents[n]->Productions().size(), std::size_t{kRules});
    EXPECT_EQ(agents[n]->rete().CheckInvariants(), "");
  }
}

TEST(RuleSharing, WhatOneAgentDoesToItsRulesIsNoneOfTheOthersBusiness) {
  std::vector<std::unique_ptr<Agent>> agents;
  for (int n = 0; n < 3; ++n) CostOfAgent(agents, 20);
  const std::vector<ProductionId> before = agents[0]->Productions();
  ASSERT_EQ(before.size(), 20u);
  const ProductionId gone = agents[1]->FindProduction("rule*7");
  agents[1]->Excise(gone);
  EXPECT_TRUE(agents[2]->LoadProduction(RuleBody(20)).loaded);
  EXPECT_EQ(agents[0]->Productions(), before);
  EXPECT_EQ(agents[0]->FindProduction("rule*7"), gone);
  EXPECT_EQ(agents[0]->FindProduction("rule*20"), ProductionId::kNone);
  EXPECT_EQ(agents[1]->Productions().size(), 19u);
  EXPECT_EQ(agents[1]->FindProduction("rule*7"), ProductionId::kNone);
  EXPECT_EQ(agents[2]->Productions().size(), 21u);
  EXPECT_EQ(agents[2]->CountProductions(ProductionType::kUser), 21u);
  EXPECT_NE(agents[2]->FindProduction("rule*20"), ProductionId::kNone);
  for (const std::unique_ptr<Agent>& agent : agents) {
    agent->Run(RunUnit::kDecision, 1);
    EXPECT_EQ(agent->rete().CheckInvariants(), "");
  }
  EXPECT_EQ(agents[0]->Productions(), before);
}

}  // namespace
}  // namespace soarbox::kernel
