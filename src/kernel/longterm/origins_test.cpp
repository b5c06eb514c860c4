// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/origins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/longterm/long_term.h"

namespace soarbox::kernel {
namespace {

/// An agent that records origins, with the questions of these tests.
struct Mind {
  explicit Mind(std::initializer_list<std::string_view> rules, bool notes = true) {
    for (const std::string_view rule : rules) EXPECT_TRUE(agent.LoadProduction(rule).loaded) << rule;
    if (notes) origins.Begin({});
  }

  Symbol Word(std::string_view text) {
    const SymbolTable::PinScope pin(agent.mutable_symbols());
    return agent.mutable_symbols().String(text);
  }
  WmeId Find(Symbol id, std::string_view attribute) {
    WmeId found = WmeId::kNone;
    agent.memory().ForEachWmeOf(id, [&](WmeId wme) {
      if (agent.memory().wme(wme).attribute == Word(attribute)) found = wme;
    });
    return found;
  }
  WmeId Top(std::string_view attribute) { return Find(agent.goals().top().id, attribute); }
  const Origin* Of(WmeId wme) {
    const std::uint32_t place = wme == WmeId::kNone ? Origins::kNone : origins.Of(wme);
    return place == Origins::kNone ? nullptr : &origins.at(place);
  }
  std::string Text(Symbol symbol) { return ToString(agent.symbols(), symbol); }
  const OriginElement* Matched(const Origin& origin, std::string_view attribute) {
    for (const OriginElement& element : origins.Matched(origin))
      if (Text(element.attribute) == attribute && !element.acceptable) return &element;
    return nullptr;
  }
  void Run(std::uint64_t decisions) { agent.Run(RunUnit::kDecision, decisions); }

  std::unique_ptr<Origins> made;  ///< Declared before the agent, which calls it until it is destroyed.
  Agent agent{"mind"};
  Origins& origins = *(made = std::make_unique<Origins>(agent.long_term().parts()));
};

constexpr std::string_view kProposeGo =
    "propose*go (state <s> ^superstate nil ^x 3 -^hum yes) --> (<s> ^operator.name go)";
constexpr std::string_view kApplyGo = "apply*go (state <s> ^operator.name go ^x <x>) --> (<s> ^gone <x> ^hum yes)";
constexpr std::string_view kProposeHum = "propose*hum (state <s> ^hum yes) --> (<s> ^operator.name hum)";

TEST(Origins, KeepTheOperatorThatWasSelectedThenWhenAnotherIsSelectedNow) {
  Mind mind({"x (state <s> ^superstate nil) --> (<s> ^x 3)", kProposeGo, kApplyGo, kProposeHum});
  mind.Run(4);
  const Origin* const origin = mind.Of(mind.Top("gone"));
  ASSERT_NE(origin, nullptr);
  EXPECT_EQ(origin->rule->name, "apply*go");
  EXPECT_EQ(origin->decision, 1u);
  EXPECT_TRUE(origin->o_supported);
  EXPECT_EQ(mind.Text(origin->op_name), "go");
  ASSERT_NE(origin->op_origin, Origins::kNone);
  const Origin& op = mind.origins.at(origin->op_origin);
  EXPECT_TRUE(op.is_operator);
  EXPECT_EQ(op.op, origin->op);
  ASSERT_EQ(mind.origins.Proposals(op).size(), 1u);
  const Origin& proposal = mind.origins.at(mind.origins.Proposals(op).front());
  EXPECT_EQ(proposal.rule->name, "propose*go");
  const OriginElement* const x = mind.Matched(proposal, "x");
  ASSERT_NE(x, nullptr);
  EXPECT_EQ(mind.Text(x->value), "3");
  ASSERT_NE(x->origin, Origins::kNone);
  EXPECT_EQ(mind.origins.at(x->origin).rule->name, "x");
  EXPECT_EQ(mind.agent.CheckInvariants(), "");
}

TEST(Origins, OutliveTheRule) {
  Mind mind({"x (state <s> ^superstate nil) --> (<s> ^x 3)", kProposeGo, kApplyGo});
  mind.Run(2);
  mind.agent.Excise(mind.agent.FindProduction("apply*go"));
  const Origin* const origin = mind.Of(mind.Top("gone"));
  ASSERT_NE(origin, nullptr);
  EXPECT_EQ(origin->rule->name, "apply*go");
}

TEST(Origins, AreFreedWithTheirElements) {
  Mind mind({"propose*on (state <s> ^superstate nil -^lamp on) --> (<s> ^operator.name on)",
             "apply*on (state <s> ^operator.name on) --> (<s> ^lamp on)",
             "propose*off (state <s> ^lamp on) --> (<s> ^operator.name off)",
             "apply*off (state <s> ^operator.name off) --> (<s> ^lamp on -)"});
  mind.Run(2);
  ASSERT_NE(mind.Of(mind.Top("lamp")), nullptr);
  mind.Run(1);
  EXPECT_EQ(mind.Top("lamp"), WmeId::kNone);
  mind.agent.InitSoar();
  EXPECT_EQ(mind.origins.count(), 0u);
}

/// Each value of the counter depends on the previous one: an endless chain unless links are cut.
TEST(Origins, StayBoundedOver100000Decisions) {
  Mind mind({"start (state <s> ^superstate nil) --> (<s> ^begun yes)",
             "propose*init (state <s> ^superstate nil -^n) --> (<s> ^operator.name init)",
             "apply*init (state <s> ^operator.name init) --> (<s> ^n 0)",
             "propose*count (state <s> ^n <n>) --> (<s> ^operator <o> + =) (<o> ^name count ^from <n>)",
             "apply*count (state <s> ^operator <o> ^n <n>) (<o> ^name count ^from <n>) -->"
             " (<s> ^n <n> - ^n (+ <n> 1))"});
  mind.Run(1000);
  const std::size_t count = mind.origins.count(), bytes = mind.origins.Bytes();
  EXPECT_GT(count, 3u);
  EXPECT_LT(count, 100u);
  for (int n = 0; n < 99; ++n) {
    mind.Run(1000);
    EXPECT_LT(mind.origins.count(), 100u);
  }
  EXPECT_LE(mind.origins.Bytes(), 2 * bytes);
  const Origin* const origin = mind.Of(mind.Top("n"));
  ASSERT_NE(origin, nullptr);
  const OriginElement* const n = mind.Matched(*origin, "n");
  ASSERT_NE(n, nullptr);
  ASSERT_NE(n->origin, Origins::kNone);
  EXPECT_EQ(mind.origins.at(n->origin).rule->name, "apply*count");
  EXPECT_EQ(mind.agent.CheckInvariants(), "");
}

TEST(Origins, AnOldElementKeepsItsOriginAndWhatThatLedTo) {
  Mind mind({"start (state <s> ^superstate nil) --> (<s> ^begun yes)",
             "propose*init (state <s> ^begun yes -^n) --> (<s> ^operator.name init)",
             "apply*init (state <s> ^operator.name init) --> (<s> ^n 0 ^mark yes)",
             "propose*count (state <s> ^n <n>) --> (<s> ^operator <o> + =) (<o> ^name count ^from <n>)",
             "apply*count (state <s> ^operator <o> ^n <n>) (<o> ^name count ^from <n>) -->"
             " (<s> ^n <n> - ^n (+ <n> 1))"},
            false);
  mind.origins.Begin([](const Goal&) { return std::string_view("the only one"); });
  mind.Run(500);
  mind.agent.Excise(mind.agent.FindProduction("apply*init"));
  mind.Run(500);
  const Origin* const origin = mind.Of(mind.Top("mark"));
  ASSERT_NE(origin, nullptr);
  EXPECT_EQ(origin->rule->name, "apply*init");
  EXPECT_EQ(origin->decision, 1u);
  EXPECT_EQ(mind.Text(origin->op_name), "init");
  ASSERT_NE(origin->op_origin, Origins::kNone);
  const Origin& op = mind.origins.at(origin->op_origin);
  EXPECT_EQ(mind.origins.Decided(op), "the only one");
  ASSERT_EQ(mind.origins.Proposals(op).size(), 1u);
  const Origin& proposal = mind.origins.at(mind.origins.Proposals(op).front());
  EXPECT_EQ(proposal.rule->name, "propose*init");
  const OriginElement* const begun = mind.Matched(proposal, "begun");
  ASSERT_NE(begun, nullptr);
  ASSERT_NE(begun->origin, Origins::kNone);
  EXPECT_EQ(mind.origins.at(begun->origin).rule->name, "start");
  EXPECT_EQ(mind.agent.CheckInvariants(), "");
}

void LoadSubstateRules(Agent& agent) {
  for (const std::string_view rule :
       {"propose*serve (state <s> ^superstate nil -^holds) --> (<s> ^operator.name serve)",
        "fetch*propose (state <s> ^superstate <t>) (<t> ^operator.name serve) --> (<s> ^operator.name fetch)",
        "fetch*apply (state <s> ^operator.name fetch ^superstate <t>) --> (<t> ^holds soup)"})
    EXPECT_TRUE(agent.LoadProduction(rule).loaded) << rule;
}

TEST(Origins, OfResultsNameTheRuleOfTheSubstate) {
  for (const bool learns : {false, true}) {
    Mind mind({});
    LoadSubstateRules(mind.agent);
    if (learns) mind.agent.ChangeLearning([](LearnSettings& settings) { settings.mode = LearnMode::kAlways; });
    mind.Run(4);
    const Origin* const origin = mind.Of(mind.Top("holds"));
    ASSERT_NE(origin, nullptr) << learns;
    EXPECT_EQ(origin->rule->name, "fetch*apply") << learns;
    EXPECT_EQ(mind.Text(origin->op_name), "fetch") << learns;
    EXPECT_EQ(origin->level, 2) << learns;
    EXPECT_EQ(mind.agent.CheckInvariants(), "");
    if (!learns) continue;
    // After init-soar the learned rule fires itself.
    mind.agent.InitSoar();
    mind.Run(3);
    const Origin* const again = mind.Of(mind.Top("holds"));
    ASSERT_NE(again, nullptr);
    EXPECT_EQ(again->rule->type, ProductionType::kChunk);
  }
}

TEST(Origins, ChangeNothingOfARun) {
  std::string dumps[2];
  for (const bool notes : {false, true}) {
    Mind mind({}, notes);
    LoadSubstateRules(mind.agent);
    ASSERT_TRUE(mind.agent
                    .LoadProduction("count (state <s> ^superstate nil ^operator.name serve) --> (<s> ^made <new>)"
                                    " (<new> ^seen yes)")
                    .loaded);
    for (int n = 0; n < 50; ++n) {
      mind.Run(7);
      dumps[notes] += std::to_string(mind.agent.memory().last_timetag()) + ' ' +
                      std::to_string(mind.agent.memory().wme_count()) + ' ' +
                      std::to_string(mind.agent.counters().elaborations) + '\n';
      if (n % 10 == 9) mind.agent.InitSoar();
    }
  }
  EXPECT_EQ(dumps[0], dumps[1]);
}

TEST(Origins, NothingIsNotedUntilSomebodyAsks) {
  Mind mind({"x (state <s> ^superstate nil) --> (<s> ^x 3)", kProposeGo, kApplyGo}, false);
  mind.Run(3);
  EXPECT_FALSE(mind.origins.on());
  EXPECT_EQ(mind.origins.count(), 0u);
}

}  // namespace
}  // namespace soarbox::kernel
