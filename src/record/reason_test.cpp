// SPDX-License-Identifier: BSD-2-Clause
// Recorded reasons for selections of operators, with running minds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "record/recorder.h"
#include "record/run_test_support.h"
#include "record/ticks_test_support.h"
#include "sim/simulation.h"
#include "wording/mind_words.h"

namespace soarbox::record {
namespace {

using testing::MatchesRegex;

mind::EventLog MindOf(const TickRecord& record) {
  return record.minds.empty() ? mind::EventLog() : record.minds[0].events;
}

/// The first decisions of an agent with these rules, optionally after a command.
wording::MindWords FirstDecisions(const std::string& rules, const std::string& command) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "scout.soar") << rules;
  const sim::Scenario scenario = sim::FindScenario((scratch.path() / "scout.soar").string(), Data()).value();
  sim::SimulationSettings settings;
  settings.soar.threads = 1;
  settings.mind_detail = DetailOf(Level::kDecisions);
  const std::unique_ptr<sim::Simulation> simulation = std::move(sim::Simulation::Create(scenario, settings).value());
  if (!command.empty()) simulation->Submit(sim::CommandInput{simulation->AgentOfMind(0), command});
  TickRecord record;
  for (int i = 0; i < 5 && wording::Words(MindOf(record)).decisions.empty(); ++i) {
    simulation->Tick();
    Observe(*simulation, simulation->TakeEvents(), Level::kDecisions, record);
  }
  return wording::Words(MindOf(record));
}

constexpr const char* kEither = R"(sp {scout*either
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <one> + = ^operator <other> + =)
   (<one> ^name one)
   (<other> ^name other)
})";

/// a is better than b, b is better than a, and no preference mentions c.
constexpr const char* kCircle = R"(sp {scout*propose
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <a> + ^operator <b> + ^operator <c> +)
   (<a> ^name a)
   (<b> ^name b)
   (<c> ^name c)
}
sp {scout*ab
   (state <s> ^operator <a> + ^operator <b> +)
   (<a> ^name a)
   (<b> ^name b)
-->
   (<s> ^operator <a> > <b>)
}
sp {scout*ba
   (state <s> ^operator <a> + ^operator <b> +)
   (<a> ^name a)
   (<b> ^name b)
-->
   (<s> ^operator <b> > <a>)
})";

TEST(Reasons, AnOperatorThatSelectForcedSaysSo) {
  const wording::MindWords free = FirstDecisions(kEither, "");
  ASSERT_FALSE(free.decisions.empty());
  EXPECT_EQ(
      free.reasons[0],
      "chosen by chance, with a probability of 50 %, among 2 indifferent operators; proposed by rule scout*either");
  // The other operator has the number before or after it; there is no operator with the third number.
  int number = 0;
  ASSERT_EQ(std::sscanf(free.decisions[0].c_str(), "O: O%d", &number), 1) << free.decisions[0];
  int forced = 0;
  for (const int other : {number - 1, number + 1}) {
    const std::string id = "O" + std::to_string(other);
    const wording::MindWords decided = FirstDecisions(kEither, "decide select " + id);
    ASSERT_FALSE(decided.decisions.empty());
    if (decided.decisions == free.decisions) {
      EXPECT_EQ(decided.reasons, free.reasons);
      continue;
    }
    ++forced;
    EXPECT_EQ(decided.decisions[0].find("O: " + id + " "), 0u) << decided.decisions[0];
    EXPECT_EQ(decided.reasons[0], "the command decide select had selected it; proposed by rule scout*either");
  }
  EXPECT_EQ(forced, 1);
}

TEST(Reasons, TwoThatAreEachBetterThanTheOtherLeaveTheThird) {
  const wording::MindWords record = FirstDecisions(kCircle, "");
  ASSERT_FALSE(record.decisions.empty());
  EXPECT_EQ(record.decisions[0].substr(record.decisions[0].find('(')), "(c)");
  EXPECT_THAT(record.reasons[0],
              MatchesRegex("b \\([A-Z][0-9]+\\) and a \\([A-Z][0-9]+\\) are each better than the other "
                           "\\(rules scout\\*(ab and scout\\*ba|ba and scout\\*ab)\\), so both were "
                           "dropped; proposed by rule scout\\*propose"));
}

TEST(Reasons, AnImpasseSaysBetweenWhat) {
  const wording::MindWords record = FirstDecisions(R"(sp {scout*either
   (state <s> ^superstate nil ^io.input-link.self)
-->
   (<s> ^operator <one> + ^operator <other> +)
   (<one> ^name one)
   (<other> ^name other)
})",
                                                   "");
  ASSERT_FALSE(record.decisions.empty());
  EXPECT_THAT(record.decisions[0], testing::HasSubstr("(operator tie)"));
  EXPECT_THAT(record.reasons[0], MatchesRegex("no preference decides among (one|other) \\([A-Z][0-9]+\\) and "
                                              "(one|other) \\([A-Z][0-9]+\\)"));
}

TEST(Reasons, AMindThatWaitsSaysSoOnce) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "scout.soar") << "soar wait-snc on\n" << kEither;
  std::ofstream(scratch.path() / "scout.soar", std::ios::app)
      << "\nsp {scout*never (state <s> ^superstate nil ^io.input-link.self.health < 0) --> (halt)}\nexcise "
         "scout*either\n";
  const sim::Scenario scenario = sim::FindScenario((scratch.path() / "scout.soar").string(), Data()).value();
  sim::SimulationSettings settings;
  settings.soar.threads = 1;
  settings.mind_detail = DetailOf(Level::kDecisions);
  const std::unique_ptr<sim::Simulation> simulation = std::move(sim::Simulation::Create(scenario, settings).value());
  std::vector<std::string> decisions;
  for (int i = 0; i < 20; ++i) {
    simulation->Tick();
    for (const std::string& line : wording::Words(simulation->Mind(0).events).decisions) decisions.push_back(line);
  }
  EXPECT_EQ(decisions, std::vector<std::string>{"==>S: S1"});
}

TEST(Reasons, AMindNotesOriginsOnlyIfSomethingCanAskForThem) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "scout.soar") << kEither;
  const sim::Scenario scenario = sim::FindScenario((scratch.path() / "scout.soar").string(), Data()).value();
  for (const bool can_ask : {false, true}) {
    sim::SimulationSettings settings;
    settings.soar.threads = 1;
    settings.mind_detail = DetailOf(Level::kDecisions);
    settings.records_origins = can_ask;
    const std::unique_ptr<sim::Simulation> simulation = std::move(sim::Simulation::Create(scenario, settings).value());
    const std::string agent = simulation->AgentOfMind(0);
    const auto notes = [&] { return simulation->Inspect(agent)->origins.Of(1).noted; };
    simulation->Tick();
    EXPECT_FALSE(simulation->Mind(0).events.empty());
    EXPECT_EQ(notes(), can_ask);
    // Somebody begins to watch this agent.
    EXPECT_TRUE(simulation->NoteMind(agent, sim::MindDetail::kAll));
    EXPECT_TRUE(notes());
  }
}

}  // namespace
}  // namespace soarbox::record
