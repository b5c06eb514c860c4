// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "kernel/agent.h"
#include "kernel/learn/explanation_log.h"
#include "kernel/learn/identity_graph.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/rules/print_production.h"

namespace soarbox::kernel {
namespace {

TEST(IdentityGraph, JoinedSetsShareARootAndWhatIsLiteralInOneIsLiteralInAll) {
  IdentityGraph graph;
  const auto a = graph.Of({1, 0}), b = graph.Of({1, 1}), c = graph.Of({2, 0});
  EXPECT_EQ(graph.Of({1, 0}), a);
  graph.Literalize(b);
  graph.Join(a, c);
  EXPECT_EQ(graph.Root(a), graph.Root(c));
  EXPECT_NE(graph.Root(a), graph.Root(b));
  EXPECT_FALSE(graph.literal(a));
  graph.Join(c, b);
  EXPECT_TRUE(graph.literal(a));
}

TEST(IdentityGraph, AgreesWithClosureByHandOverRandomLinks) {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    IdentityGraph graph;
    std::vector<int> set_of(40);
    for (int n = 0; n < 40; ++n) set_of[static_cast<std::size_t>(n)] = n;
    for (int link = 0; link < 25; ++link) {
      const std::uint32_t a = random() % 40, b = random() % 40;
      graph.Join(graph.Of({a, 3}), graph.Of({b, 3}));
      const int from = set_of[a], to = set_of[b];
      std::ranges::replace(set_of, from, to);
    }
    for (std::uint32_t a = 0; a < 40; ++a) {
      for (std::uint32_t b = 0; b < 40; ++b) {
        EXPECT_EQ(set_of[a] == set_of[b], graph.Root(graph.Of({a, 3})) == graph.Root(graph.Of({b, 3})));
      }
    }
  }
}

/// A task in the top state that rules solve in a substate.
class ChunkingTest : public testing::Test {
 protected:
  void Load(Agent& agent, std::string_view body) { ASSERT_TRUE(agent.LoadProduction(body).loaded) << body; }
  void Learn(Agent& agent) {
    agent.ChangeLearning([](LearnSettings& settings) { settings.mode = LearnMode::kAlways; });
  }
  /// The values of an attribute of the top state, sorted.
  std::vector<std::string> Top(const Agent& agent, std::string_view attribute) {
    std::vector<std::string> found;
    for (const WmeId wme : agent.memory().WmesOf(agent.goals().top().id)) {
      const Wme& content = agent.memory().wme(wme);
      if (content.acceptable || ToString(agent.symbols(), content.attribute) != attribute) continue;
      found.push_back(ToString(agent.symbols(), content.value));
    }
    std::ranges::sort(found);
    return found;
  }
  std::vector<std::string> Learned(const Agent& agent) {
    std::vector<std::string> rules;
    for (const ProductionId id : agent.Productions()) {
      if (agent.production(id).type == ProductionType::kChunk) rules.emplace_back(agent.production(id).name);
    }
    return rules;
  }
  void Task(Agent& agent, int size, int weight) {
    Load(agent, "init (state <s> ^superstate nil) --> (<s> ^box <b>) (<b> ^size " + std::to_string(size) + " ^weight " +
                    std::to_string(weight) + ")");
    Load(agent, "go (state <s> ^superstate nil -^done) --> (<s> ^operator.name go)");
  }
  void Method(Agent& agent) {
    Load(agent,
         "copy (state <s> ^superstate <ss>) (<ss> ^operator.name go ^box <b>) (<b> ^size <n> ^weight { <w> < <n> }) "
         "--> (<s> ^size <n> ^weight <w>)");
    Load(agent, "fin (state <s> ^superstate <ss> ^size { <n> > 3 } ^weight <w>) --> (<ss> ^done <n> ^left <w>)");
  }
};

TEST_F(ChunkingTest, OffNothingIsLearned) {
  Agent agent("a");
  Task(agent, 7, 2);
  Method(agent);
  agent.Run(RunUnit::kDecision, 4);
  EXPECT_THAT(Top(agent, "done"), testing::ElementsAre("7"));
  EXPECT_THAT(Learned(agent), testing::IsEmpty());
}

TEST_F(ChunkingTest, ALearnedRuleDoesInOneStepWhatTheSubstateDid) {
  Agent agent("a");
  Learn(agent);
  Task(agent, 7, 2);
  Method(agent);
  agent.Run(RunUnit::kDecision, 4);
  ASSERT_THAT(Learned(agent), testing::ElementsAre("chunk*fin*t2-1"));
  agent.InitSoar();
  agent.Run(RunUnit::kDecision, 2);
  EXPECT_THAT(Top(agent, "done"), testing::ElementsAre("7"));
  EXPECT_EQ(agent.CheckInvariants(), "");
}

/// The oracle: a learned rule is loaded alone in an agent with a task of the same shape. It must create exactly the
/// results that the substate creates for that task.
TEST_F(ChunkingTest, ALearnedRuleIsRightForOtherValuesToo) {
  Agent teacher("a");
  Learn(teacher);
  Task(teacher, 7, 2);
  Method(teacher);
  teacher.Run(RunUnit::kDecision, 4);
  ASSERT_EQ(Learned(teacher).size(), 1u);
  const std::string text =
      PrintProduction(teacher.symbols(), teacher.production(teacher.FindProduction(Learned(teacher)[0])));
  const std::size_t open = text.find('{'), close = text.rfind('}');
  const std::string body = text.substr(open + 1, close - open - 1);
  std::mt19937 random(11);
  int with_result = 0;
  for (int round = 0; round < 40; ++round) {
    const int size = static_cast<int>(random() % 8), weight = static_cast<int>(random() % 8);
    Agent slow("slow"), fast("fast");
    Task(slow, size, weight);
    Method(slow);
    slow.Run(RunUnit::kDecision, 4);
    Task(fast, size, weight);
    Load(fast, body);
    fast.Run(RunUnit::kDecision, 4);
    EXPECT_EQ(Top(slow, "done"), Top(fast, "done")) << size << " " << weight << "\n" << body;
    EXPECT_EQ(Top(slow, "left"), Top(fast, "left")) << size << " " << weight;
    with_result += Top(slow, "done").empty() ? 0 : 1;
  }
  EXPECT_GT(with_result, 5);
  EXPECT_LT(with_result, 35);
}

TEST_F(ChunkingTest, AVariableThatIsMarkedLiteralStaysAConstant) {
  // The mark must count in the condition on the superstate, and in the condition through which the substate passes the
  // value on.
  for (const bool marks_superstate : {false, true}) {
    Agent agent("a");
    Learn(agent);
    Task(agent, 7, 2);
    Load(agent, marks_superstate ? "copy (state <s> ^superstate.box.size $ <n>) --> (<s> ^n <n>)"
                                 : "copy (state <s> ^superstate.box.size <n>) --> (<s> ^n <n>)");
    Load(agent, marks_superstate ? "fin (state <s> ^superstate <ss> ^n <n>) --> (<ss> ^done <n>)"
                                 : "fin (state <s> ^superstate <ss> ^n { <n> $$ <n> > 3 }) --> (<ss> ^done <n>)");
    agent.Run(RunUnit::kDecision, 4);
    ASSERT_EQ(Learned(agent).size(), 1u);
    const std::string rule =
        PrintProduction(agent.symbols(), agent.production(agent.FindProduction(Learned(agent)[0])));
    EXPECT_THAT(rule, testing::HasSubstr("^size 7")) << rule;
    EXPECT_THAT(rule, testing::HasSubstr("^done 7")) << rule;
    EXPECT_EQ(agent.CheckInvariants(), "");
  }
}

TEST_F(ChunkingTest, AnIdentifierThatIsMarkedLiteralStaysAVariable) {
  Agent agent("a");
  Learn(agent);
  Task(agent, 7, 2);
  Load(agent, "fin (state <s> ^superstate <ss>) (<ss> ^box $ <b>) (<b> ^size <n>) --> (<ss> ^done <n>)");
  agent.Run(RunUnit::kDecision, 4);
  ASSERT_EQ(Learned(agent).size(), 1u);
  const std::string rule = PrintProduction(agent.symbols(), agent.production(agent.FindProduction(Learned(agent)[0])));
  EXPECT_THAT(rule, testing::HasSubstr("^box <b")) << rule;
  EXPECT_THAT(rule, testing::HasSubstr("^done <")) << rule;
}

TEST_F(ChunkingTest, WhatIsComputedFromAValueMakesItAConstant) {
  Agent agent("a");
  Learn(agent);
  Task(agent, 7, 2);
  Load(agent, "copy (state <s> ^superstate.box.size <n>) --> (<s> ^n (+ <n> 1))");
  Load(agent, "fin (state <s> ^superstate <ss> ^n <n>) --> (<ss> ^done <n>)");
  agent.Run(RunUnit::kDecision, 4);
  ASSERT_EQ(Learned(agent).size(), 1u);
  const Production& rule = agent.production(agent.FindProduction(Learned(agent)[0]));
  bool tests_seven = false;
  for (const Condition& condition : rule.conditions) {
    tests_seven |= ToString(agent.symbols(), EqualitySymbol(condition.value)) == "7";
  }
  EXPECT_TRUE(tests_seven);
}

TEST_F(ChunkingTest, DuplicatesAreCountedAndNotKept) {
  Agent agent("a");
  Learn(agent);
  Load(agent, "init (state <s> ^superstate nil) --> (<s> ^n 1 ^n 2 ^operator.name go)");
  Load(agent, "fin (state <s> ^superstate <ss>) (<ss> ^operator.name go ^n <n>) --> (<ss> ^done <n>)");
  agent.Run(RunUnit::kDecision, 4);
  EXPECT_EQ(Learned(agent).size(), 1u);
  EXPECT_EQ(agent.learn_statistics().duplicates, 1u);
  EXPECT_THAT(Top(agent, "done"), testing::ElementsAre("1", "2"));
  EXPECT_EQ(agent.CheckInvariants(), "");
}

TEST_F(ChunkingTest, ExplanationsSayWhereEachConditionCameFrom) {
  Agent agent("a");
  Learn(agent);
  agent.mutable_explanations().all = true;
  Task(agent, 7, 2);
  Method(agent);
  agent.Run(RunUnit::kDecision, 4);
  ASSERT_EQ(agent.explanations().rules().size(), 1u);
  const ExplainedRule& rule = agent.explanations().rules().front();
  EXPECT_EQ(rule.name, "chunk*fin*t2-1");
  EXPECT_EQ(rule.firings.size(), 2u);
  for (const ExplainedRule::Condition& condition : rule.conditions) {
    EXPECT_FALSE(condition.path.empty());
    EXPECT_EQ(condition.path.back(), rule.base);
  }
  ASSERT_NE(rule.FindFiring(rule.base), nullptr);
  EXPECT_EQ(rule.FindFiring(rule.base)->rule, "fin");
  agent.InitSoar();
  EXPECT_TRUE(agent.explanations().rules().empty());
}

}  // namespace
}  // namespace soarbox::kernel
