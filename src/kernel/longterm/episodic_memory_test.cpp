// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episodic_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "kernel/longterm/long_term.h"

namespace soarbox::kernel {
namespace {

/// The constants of the top state in working memory, as "attribute value", and its links, as "attribute".
std::multiset<std::string> Remembered(const Agent& agent) {
  std::multiset<std::string> found;
  std::vector<Symbol> objects = {agent.goals().top().id};
  for (std::size_t n = 0; n < objects.size(); ++n) {
    for (const WmeId id : agent.memory().WmesOf(objects[n])) {
      const Wme& wme = agent.memory().wme(id);
      std::string attribute = ToString(agent.symbols(), wme.attribute, false) + (wme.acceptable ? "*" : "");
      if (attribute == "epmem" || attribute == "smem") continue;
      if (!wme.value.IsIdentifier()) {
        found.insert(attribute + " " + ToString(agent.symbols(), wme.value, false));
        continue;
      }
      found.insert(attribute);
      if (std::find(objects.begin(), objects.end(), wme.value) == objects.end()) objects.push_back(wme.value);
    }
  }
  return found;
}

std::multiset<std::string> Recorded(const EpisodicMemory& memory, EpisodeNumber episode) {
  std::multiset<std::string> found;
  for (const EpisodeFact fact : memory.store().Replay(episode)) {
    const EpisodeTriple triple = memory.store().triple(fact);
    std::string text = memory.terms().Show(triple.attribute);
    if (!triple.value.IsNode()) text += " " + memory.terms().Show(triple.value.term());
    found.insert(text);
  }
  return found;
}

class EpisodicMemoryTest : public testing::Test {
 protected:
  EpisodicMemoryTest() : agent_("scout") { memory().SetLearning(true); }

  EpisodicMemory& memory() { return EpisodicMemory::Of(agent_.long_term()); }
  void Load(std::string_view rule) { ASSERT_TRUE(agent_.LoadProduction(rule).loaded) << rule; }
  void Cycle(int count = 1) {
    for (int n = 0; n < count; ++n) agent_.Step(RunUnit::kDecision);
  }
  Symbol ResultOf(std::string_view attribute) {
    const Symbol result = agent_.goals().top().epmem.result;
    return agent_.memory().ValueOf(result, agent_.mutable_symbols().String(attribute));
  }

  Agent agent_;
};

TEST_F(EpisodicMemoryTest, AnEpisodeIsWhatHangsOnTheTopState) {
  agent_.mutable_settings().wait_snc = true;
  std::mt19937 random(11);
  std::map<std::int64_t, InputElement> elements;
  Load("in (state <s> ^superstate nil ^io.input-link <il>) (<il> ^a <x>) --> (<s> ^copy <x> ^pair <p>) (<p> ^of <x>)");
  Load("drop (state <s> ^superstate nil ^pair <p>) (<p> ^of 2) --> (<p> ^odd <o>) (<o> ^back <p>)");
  for (EpisodeNumber step = 1; step <= 200; ++step) {
    const std::int64_t value = static_cast<std::int64_t>(random() % 5);
    if (const auto found = elements.find(value); found != elements.end()) {
      agent_.input().Remove(found->second);
      elements.erase(found);
    } else {
      elements[value] = agent_.input().Add(InputObject::kInputLink, "a", value);
    }
    Cycle();
    ASSERT_EQ(memory().store().last(), step);
    ASSERT_EQ(Recorded(memory(), step), Remembered(agent_)) << "step " << step;
    ASSERT_STREQ(memory().store().CheckInvariants(), "");
  }
  // Objects are added and removed, and the store is never larger than working memory has been.
  EXPECT_LT(memory().store().node_count(), 30u);
}

TEST_F(EpisodicMemoryTest, ADecisionInWhichNothingChangesCostsNoChange) {
  agent_.mutable_settings().wait_snc = true;
  Cycle(10);
  EXPECT_EQ(memory().store().last(), 10u);
  EXPECT_TRUE(memory().store().LastChanges().empty());
}

TEST_F(EpisodicMemoryTest, AnAgentWithoutEpisodicMemoryHasNone) {
  Agent other("other");
  other.Step(RunUnit::kDecision);
  EXPECT_EQ(EpisodicMemory::Find(other.long_term()), nullptr);
}

TEST_F(EpisodicMemoryTest, ACommandIsAnsweredOnceAndAgainWhenItChanges) {
  agent_.mutable_settings().wait_snc = true;
  Load("ask (state <s> ^superstate nil ^io.input-link.ask <n> ^epmem.command <c>) --> (<c> ^retrieve <n>)");
  Cycle(3);
  const InputElement ask = agent_.input().Add(InputObject::kInputLink, "ask", std::int64_t{2});
  Cycle();
  EXPECT_EQ(ResultOf("memory-id"), Symbol::SmallInteger(2));
  const Symbol first = ResultOf("retrieved");
  Cycle(2);
  EXPECT_EQ(ResultOf("retrieved"), first);
  EXPECT_EQ(memory().counters().retrievals, 1u);
  agent_.input().Update(ask, std::int64_t{1});
  Cycle();
  EXPECT_EQ(ResultOf("memory-id"), Symbol::SmallInteger(1));
  EXPECT_EQ(memory().counters().retrievals, 2u);
  agent_.input().Remove(ask);
  Cycle();
  EXPECT_TRUE(ResultOf("memory-id").IsNone());
  EXPECT_TRUE(ResultOf("retrieved").IsNone());
}

TEST_F(EpisodicMemoryTest, InitSoarForgets) {
  agent_.mutable_settings().wait_snc = true;
  Cycle(5);
  agent_.InitSoar();
  EXPECT_EQ(memory().time(), 1u);
  Cycle(2);
  EXPECT_EQ(Recorded(memory(), 2), Remembered(agent_));
}

TEST_F(EpisodicMemoryTest, ASubstateThatGoesTakesItsAnswersWithIt) {
  Load("ask (state <s> ^superstate <ss> ^epmem.command <c>) (<ss> ^superstate nil) --> (<c> ^query.type state)");
  Load("stop (state <s> ^superstate nil ^io.input-link.go) --> (<s> ^operator <o> +)");
  Cycle(4);
  ASSERT_GT(agent_.goals().depth(), 1u);
  agent_.input().Add(InputObject::kInputLink, "go", std::int64_t{1});
  Cycle(1);
  EXPECT_EQ(agent_.CheckInvariants(), "");
  Cycle(3);
  EXPECT_EQ(agent_.CheckInvariants(), "");
}

}  // namespace
}  // namespace soarbox::kernel
