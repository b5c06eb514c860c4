// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/agent.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace soarbox::kernel {
namespace {

/// Records decisions, prints, removals and the order of the waterfall as short words.
class Log : public Observer {
 public:
  void OnDecision(const Agent& agent, const GoalInfo& goal, std::uint64_t) override {
    lines.push_back(ToString(agent.symbols(), goal.op ? goal.op : goal.goal));
  }
  void OnStateRemoved(const Agent& agent, const GoalInfo& goal, GoalRemoval reason) override {
    lines.push_back("-" + ToString(agent.symbols(), goal.goal) + (reason == GoalRemoval::kGdsChange ? " gds" : ""));
  }
  void OnPrint(const Agent&, std::string_view text) override { printed += text; }
  void OnInterrupt(const Agent&, std::string_view) override { lines.push_back("interrupt"); }
  void OnHalt(const Agent&) override { lines.push_back("halt"); }

  std::vector<std::string> lines;
  std::string printed;
};

class AgentTest : public testing::Test {
 protected:
  AgentTest() { agent.AddObserver(log, Event::kDecision | Event::kPrint | Event::kRun); }
  ~AgentTest() override { EXPECT_EQ(agent.CheckInvariants(), ""); }

  void Load(std::string_view body) { EXPECT_TRUE(agent.LoadProduction(body).loaded) << body; }
  Symbol Text(std::string_view text) { return agent.mutable_symbols().String(text); }
  Symbol Top() const { return agent.goals().top().id; }
  /// The values of an attribute as text, newest first.
  std::string Values(Symbol id, std::string_view attribute) {
    std::string found;
    for (const WmeId wme : agent.memory().WmesOf(id)) {
      const Wme& content = agent.memory().wme(wme);
      if (content.attribute != Text(attribute) || content.acceptable) continue;
      found += (found.empty() ? "" : " ") + ToString(agent.symbols(), content.value);
    }
    return found;
  }

  Agent agent{"test"};
  Log log;
};

// Working memory --------------------------------------------------------------------------------------------------

TEST_F(AgentTest, AFreshAgentHasThirteenElements) {
  EXPECT_EQ(agent.memory().wme_count(), 13u);
  EXPECT_EQ(agent.memory().last_timetag(), 13u);
  EXPECT_EQ(ToString(agent.symbols(), agent.OutputLinkIdentifier()), "I3");
}

TEST_F(AgentTest, TimeTagsOfOneWaveFollowTheOrderInWhichSlotsAreTouched) {
  Load("a (state <s> ^superstate nil) --> (<s> ^x a1 a2 a3 ^y 1)");
  Load("b (state <s> ^superstate nil) --> (<s> ^x b1x b2x ^z 2 ^x b3x)");
  agent.InitSoar();
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(agent.memory().wme(agent.memory().FindByTimetag(14)).attribute, Text("y"));
  EXPECT_EQ(agent.memory().wme(agent.memory().FindByTimetag(15)).attribute, Text("z"));
  EXPECT_EQ(agent.memory().wme(agent.memory().FindByTimetag(16)).value, Text("b3x"));
}

TEST_F(AgentTest, StructureThatLosesItsLastLinkIsCollectedEvenIfItIsACircle) {
  Load(
      "make (state <s> ^superstate nil -^gone yes) --> (<s> ^ring <a>) (<a> ^next <b>) (<b> ^next <c>) (<c> ^next "
      "<a>)");
  Load("work (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name cut)");
  Load("cut (state <s> ^operator.name cut) --> (<s> ^gone yes)");
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_NE(Values(Top(), "ring"), "");
  const Symbol ring = agent.memory().ValueOf(Top(), Text("ring"));
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Values(Top(), "ring"), "");
  EXPECT_EQ(agent.memory().ValueOf(ring, Text("next")), Symbol());
}

TEST_F(AgentTest, AnOSupportedCircleIsCollectedWhenItsLinkIsRejected) {
  Load("propose (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name turn)");
  Load("make (state <s> ^operator.name turn -^loop -^cut) --> (<s> ^loop <x>) (<x> ^to <y>) (<y> ^to <x>)");
  Load("cut (state <s> ^operator.name turn ^loop <x>) --> (<s> ^loop <x> - ^cut yes)");
  agent.Run(RunUnit::kDecision, 2);
  EXPECT_EQ(Values(Top(), "cut"), "yes");
  for (const Wme& wme : agent.memory().wmes()) EXPECT_FALSE(wme.live && wme.attribute == Text("to"));
}

TEST_F(AgentTest, AnOSupportedFactStaysAndAnISupportedOneGoes) {
  Load("propose (state <s> ^superstate nil -^done yes) --> (<s> ^operator <o> + ^mood eager) (<o> ^name do)");
  Load("apply (state <s> ^operator.name do) --> (<s> ^done yes)");
  agent.Run(RunUnit::kDecision, 2);
  EXPECT_EQ(Values(Top(), "done"), "yes");
  EXPECT_EQ(Values(Top(), "mood"), "");
}

// Goals -----------------------------------------------------------------------------------------------------------

TEST_F(AgentTest, ASubstateGoesWhenWhatItsFirstFactRestsOnChanges) {
  const InputElement star = agent.input().Add(InputObject::kInputLink, "star", std::string_view("vega"));
  Load("propose (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name watch)");
  Load("sub (state <s> ^impasse no-change ^superstate.operator.name watch) --> (<s> ^operator <o> +) (<o> ^name note)");
  Load("note (state <s> ^operator.name note ^superstate.io.input-link.star <x>) --> (<s> ^noted <x>)");
  agent.Run(RunUnit::kDecision, 4);
  EXPECT_EQ(agent.goals().depth(), 3u);
  agent.input().Update(star, std::string_view("deneb"));
  log.lines.clear();
  agent.Run(RunUnit::kDecision, 1);
  ASSERT_FALSE(log.lines.empty());
  EXPECT_EQ(log.lines.front(), "-S2 gds");
  EXPECT_EQ(agent.goals().depth(), 2u);
}

TEST_F(AgentTest, AResultOutlivesItsSubstateAndGoesWithItsReasons) {
  Load("propose (state <s> ^superstate nil -^result) --> (<s> ^operator <o> + ^clue yes) (<o> ^name think)");
  Load("think (state <s> ^superstate <ss>) (<ss> ^superstate nil ^io.input-link.go <g>) --> (<ss> ^result <g>)");
  const InputElement go = agent.input().Add(InputObject::kInputLink, "go", std::int64_t{7});
  agent.Run(RunUnit::kDecision, 3);
  EXPECT_EQ(Values(Top(), "result"), "7");
  EXPECT_GE(agent.counters().justifications, 1u);
  agent.input().Remove(go);
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Values(Top(), "result"), "");
}

TEST_F(AgentTest, AResultLeavesNothingInTheDependencySet) {
  Load("propose (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name task)");
  Load(
      "sub (state <s> ^impasse no-change ^superstate.operator.name task) --> (<s> ^operator <o> +) (<o> ^name answer)");
  Load("answer (state <s> ^operator.name answer ^superstate <ss>) --> (<ss> ^answer yes)");
  agent.Run(RunUnit::kDecision, 4);
  EXPECT_EQ(Values(Top(), "answer"), "yes");
  ASSERT_GE(agent.goals().depth(), 2u);
  EXPECT_FALSE(agent.goals().at(2).has_gds);
}

TEST_F(AgentTest, HigherGoalsFireFirstAndLowerOnesOnlyWhereTheyDoNotDisturb) {
  Load("top-1 (state <s> ^superstate nil ^io.input-link.go yes) --> (<s> ^one yes) (write |1|)");
  Load("top-2 (state <s> ^superstate nil ^one yes) --> (<s> ^two yes) (write |2|)");
  Load("sub-a (state <s> ^superstate <t>) (<t> ^superstate nil ^io.input-link.go yes) --> (<s> ^a yes) (write |a|)");
  Load("sub-b (state <s> ^superstate <t>) (<t> ^superstate nil ^one yes) --> (<s> ^b yes) (write |b|)");
  agent.Run(RunUnit::kDecision, 2);
  agent.input().Add(InputObject::kInputLink, "go", std::string_view("yes"));
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(log.printed, "1a2b");
}

TEST_F(AgentTest, TheItemsOfATieAreListedLastCandidateFirst) {
  Load("propose (state <s> ^superstate nil) --> (<s> ^operator <a> + <b> +) (<a> ^name left) (<b> ^name right)");
  agent.Run(RunUnit::kDecision, 1);
  ASSERT_EQ(agent.goals().depth(), 2u);
  EXPECT_EQ(agent.goals().bottom().impasse, ImpasseType::kTie);
  EXPECT_EQ(Values(agent.goals().bottom().id, "item"), "A1 B1");
  EXPECT_EQ(Values(agent.goals().bottom().id, "item-count"), "2");
}

// Input and output ------------------------------------------------------------------------------------------------

TEST_F(AgentTest, OfSeveralUpdatesBetweenTwoInputPhasesTheLastCounts) {
  const InputElement speed = agent.input().Add(InputObject::kInputLink, "speed", std::int64_t{1});
  agent.input().Update(speed, std::int64_t{2});
  agent.input().Update(speed, 2.5);
  agent.Run(RunUnit::kPhase, 1);
  EXPECT_EQ(Values(agent.InputLinkIdentifier(), "speed"), "2.500000");
  EXPECT_EQ(agent.memory().last_timetag(), 16u);
}

TEST_F(AgentTest, AnElementMadeAndRemovedBetweenInputPhasesNeverEnters) {
  const InputElement ghost = agent.input().Add(InputObject::kInputLink, "ghost", std::int64_t{1});
  agent.input().Remove(ghost);
  agent.Run(RunUnit::kPhase, 1);
  EXPECT_EQ(agent.memory().wme_count(), 13u);
  agent.input().Update(ghost, std::int64_t{2});
  EXPECT_FALSE(agent.input().HasPendingChanges());
}

TEST_F(AgentTest, ASharedObjectLivesAsLongAsOneElementNamesIt) {
  InputLink& input = agent.input();
  const InputObject car = input.NewObject();
  const InputElement first = input.Add(InputObject::kInputLink, "left", car);
  input.Add(car, "colour", std::string_view("red"));
  const InputElement second = input.Add(InputObject::kInputLink, "right", car);
  agent.Run(RunUnit::kDecision, 1);
  const Symbol id = input.Identifier(car);
  EXPECT_EQ(ToString(agent.symbols(), id), "L2");
  input.Remove(first);
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Values(id, "colour"), "red");
  input.Remove(second);
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Values(id, "colour"), "");
  EXPECT_FALSE(input.Identifier(car));
}

TEST_F(AgentTest, OutputIsTheDifferenceSinceTheLastOutputPhase) {
  Load("say (state <s> ^superstate nil ^io.output-link <out>) --> (<out> ^move <m>) (<m> ^to north)");
  agent.Run(RunUnit::kOutput, 1);
  ASSERT_EQ(agent.output().new_commands().size(), 1u);
  const OutputCommand command = agent.output().new_commands().front();
  EXPECT_EQ(command.attribute, Text("move"));
  EXPECT_EQ(agent.output().changes().size(), 2u);
  agent.input().Add(agent.input().ObjectFor(command.identifier), "status", std::string_view("complete"));
  // Elements of a client are not output: changes() still has the last difference that the agent caused.
  const std::uint64_t generation = agent.output().generation();
  agent.Run(RunUnit::kDecision, 2);
  EXPECT_EQ(agent.output().generation(), generation);
  EXPECT_EQ(agent.output().changes().size(), 2u);
}

// Run control -----------------------------------------------------------------------------------------------------

TEST_F(AgentTest, RunningToOutputGivesUpAfterTheNilOutputCycles) {
  agent.mutable_settings().max_nil_output_cycles = 3;
  agent.mutable_settings().wait_snc = true;
  EXPECT_EQ(agent.Run(RunUnit::kOutput, 1).decisions, 3u);
}

TEST_F(AgentTest, ClearingTheBreakOfARuleSilencesItsOwnInterrupt) {
  Load("stop :interrupt (state <s> ^superstate nil) --> (<s> ^ready yes)");
  agent.SetBreak(agent.FindProduction("stop"), false);
  EXPECT_EQ(agent.Run(RunUnit::kDecision, 1).reason, StopReason::kCompleted);
  agent.SetBreak(agent.FindProduction("stop"), true);
  agent.InitSoar();
  EXPECT_EQ(agent.Run(RunUnit::kDecision, 1).reason, StopReason::kCompleted) << "it matched before the run began";
}

TEST_F(AgentTest, AMatchOfARuleThatInterruptsEndsTheRunAfterItsPhase) {
  Load("begin (state <s> ^superstate nil) --> (<s> ^n 1)");
  Load("stop :interrupt (state <s> ^n 1) --> (<s> ^m 2)");
  Load("next (state <s> ^m 2) --> (<s> ^o 3)");
  EXPECT_EQ(agent.Run(RunUnit::kDecision, 3).reason, StopReason::kInterrupted);
  EXPECT_EQ(agent.next_phase(), Phase::kDecide);
  EXPECT_EQ(agent.counters().firings, 3u);
  agent.SetBreak(agent.FindProduction("stop"), false);
  agent.InitSoar();
  EXPECT_EQ(agent.Run(RunUnit::kDecision, 3).reason, StopReason::kCompleted);
  agent.SetBreak(agent.FindProduction("next"), true);
  agent.InitSoar();
  EXPECT_EQ(agent.Run(RunUnit::kElaboration, 5).reason, StopReason::kInterrupted);
  EXPECT_EQ(agent.counters().firings, 2u);
}

TEST_F(AgentTest, AHaltEndsTheRunAndRefusesOthersUntilInit) {
  Load("stop (state <s> ^superstate nil) --> (halt)");
  EXPECT_EQ(agent.Run(RunUnit::kForever).reason, StopReason::kHalted);
  EXPECT_EQ(agent.Run(RunUnit::kDecision, 1).reason, StopReason::kHalted);
  agent.InitSoar();
  EXPECT_FALSE(agent.halted());
  EXPECT_EQ(agent.memory().last_timetag(), 13u);
}

TEST_F(AgentTest, AStopRequestFromAnotherThreadEndsARunForever) {
  agent.mutable_settings().wait_snc = true;
  std::thread other([&] {
    while (!agent.running()) std::this_thread::yield();
    agent.RequestStop("enough");
  });
  EXPECT_EQ(agent.Run(RunUnit::kForever).reason, StopReason::kInterrupted);
  other.join();
}

TEST_F(AgentTest, ADecisionRunStopsInFrontOfTheStopPhase) {
  agent.mutable_settings().wait_snc = true;
  agent.Run(RunUnit::kDecision, 2);
  EXPECT_EQ(agent.next_phase(), Phase::kApply);
  EXPECT_EQ(agent.counters().decision_phases, 2u);
  agent.RunToPhase(Phase::kInput);
  EXPECT_EQ(agent.counters().decision_cycles, 2u);
}

TEST_F(AgentTest, ElaborationsStopAtTheirLimitAndGoOnInTheNextPhase) {
  Load("count (state <s> ^superstate nil ^n <n>) --> (<s> ^n (+ <n> 1))");
  Load("begin (state <s> ^superstate nil) --> (<s> ^n 0)");
  agent.mutable_settings().max_elaborations = 5;
  agent.mutable_settings().wait_snc = true;
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(agent.counters().elaborations, 5u);
}

TEST_F(AgentTest, AGoalStackLimitEndsTheRunButNotTheAgent) {
  agent.mutable_settings().max_goal_depth = 3;
  EXPECT_EQ(agent.Run(RunUnit::kForever).reason, StopReason::kLimit);
  EXPECT_EQ(agent.goals().depth(), 4u);
  EXPECT_EQ(agent.Run(RunUnit::kDecision, 1).reason, StopReason::kLimit);
  EXPECT_EQ(agent.goals().depth(), 5u);
}

TEST_F(AgentTest, AHaltBelowTheGoalDepthIsTakenForTheLimit) {
  Load("stop (state <s> ^superstate.superstate.superstate <x> ^impasse no-change) --> (halt)");
  agent.mutable_settings().max_goal_depth = 3;
  EXPECT_EQ(agent.Run(RunUnit::kForever).reason, StopReason::kLimit);
  EXPECT_FALSE(agent.halted());
}

TEST_F(AgentTest, ARuleKeepsItsNumberAsLongAsItsFactsLive) {
  Load("propose (state <s> ^superstate nil -^made) --> (<s> ^operator <o> +) (<o> ^name make)");
  Load("make (state <s> ^operator.name make) --> (<s> ^made yes)");
  agent.Run(RunUnit::kDecision, 2);
  const ProductionId make = agent.FindProduction("make");
  agent.Excise(make);
  agent.Run(RunUnit::kDecision, 1);
  Load("other (state <s> ^made yes) --> (<s> ^other yes)");
  EXPECT_NE(agent.FindProduction("other"), make);
  EXPECT_EQ(agent.production(make).name, "make");
}

TEST_F(AgentTest, ExcisingAMatchedRuleTakesBackWhatItSupports) {
  Load("mood (state <s> ^superstate nil) --> (<s> ^mood calm)");
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Values(Top(), "mood"), "calm");
  agent.Excise(agent.FindProduction("mood"));
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Values(Top(), "mood"), "");
}

TEST_F(AgentTest, IdentifiersAndConstantsThatNobodyMentionsAreGivenBack) {
  Load("tick (state <s> ^superstate nil -^phase tock) --> (<s> ^operator <o> +) (<o> ^name tick)");
  Load("tock (state <s> ^superstate nil ^phase tock) --> (<s> ^operator <o> +) (<o> ^name tock)");
  Load("a-tick (state <s> ^operator.name tick) --> (<s> ^phase tock)");
  Load("a-tock (state <s> ^operator.name tock) --> (<s> ^phase tock -)");
  agent.Run(RunUnit::kDecision, 20000);
  EXPECT_EQ(agent.goals().depth(), 1u);
  EXPECT_LT(agent.memory().identifier_limit(), 3000u);
}

TEST_F(AgentTest, ThePhaseInWhichAnAgentHaltsCountsForTheSizeOfItsMemory) {
  Load("end (state <s> ^superstate nil) --> (<s> ^a 1 2 3) (halt)");
  agent.Run(RunUnit::kDecision, 1);
  ASSERT_TRUE(agent.halted());
  EXPECT_EQ(agent.counters().wm_size_maximum, agent.memory().wme_count());
}

// Partial matches -----------------------------------------------------------------------------------------------------

TEST(AgentMemory, MorePartialMatchesThanAreAllowedEndTheAgentAndNameTheRule) {
  Agent agent("greedy");
  agent.mutable_settings().max_partial_matches = 5000;
  for (const char* rule : {"values (state <s> ^superstate nil) --> (<s> ^value 1 2 3 4 5 6 7 8 9 10 11 12)",
                           "pairs (state <s> ^value <a> ^value <b>) --> (<s> ^pairs yes)"}) {
    ASSERT_TRUE(agent.LoadProduction(rule).loaded);
  }
  agent.Run(RunUnit::kDecision, 2);
  EXPECT_FALSE(agent.out_of_memory());
  EXPECT_FALSE(agent
                   .LoadProduction(
                       "explode (state <s> ^pairs yes ^value <a> ^value <b> ^value <c> ^value <d>) --> (<s> ^all yes)")
                   .loaded);
  EXPECT_TRUE(agent.out_of_memory());
  EXPECT_TRUE(agent.halted());
  EXPECT_EQ(agent.breakdown(),
            "there is no room for the matches of rule explode; 'soar max-partial-matches' allows 5000 in all");
}

TEST(AgentElaborations, PhasesEndOnceTheRulesHaveFiredOftenEnough) {
  Agent agent("busy");
  agent.mutable_settings().max_elaborations = 10'000;
  for (const char* rule : {"start (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name count)",
                           "zero (state <s> ^operator.name count -^n) --> (<s> ^n 0)",
                           "count (state <s> ^operator.name count ^n <n>) --> (<s> ^n (+ <n> 1) <n> -)"}) {
    ASSERT_TRUE(agent.LoadProduction(rule).loaded);
  }
  agent.mutable_settings().most_firings = 500;
  agent.Run(RunUnit::kDecision, 3);
  EXPECT_GE(agent.counters().firings, 500U);
  EXPECT_LT(agent.counters().firings, 510U);
}

TEST(AgentMemory, ATextThatGrowsWithoutEndEndsTheAgent) {
  Agent agent("wordy");
  agent.mutable_settings().most_memory_bytes = std::size_t{4} << 20;
  for (const char* rule : {"start (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name grow)",
                           "seed (state <s> ^operator <o> -^text) --> (<s> ^text abcdefgh)",
                           "grow (state <s> ^operator.name grow ^text <t>) --> (<s> ^text (concat <t> <t>) <t> -)"}) {
    ASSERT_TRUE(agent.LoadProduction(rule).loaded);
  }
  agent.Run(RunUnit::kDecision, 5);
  EXPECT_TRUE(agent.out_of_memory());
  EXPECT_LT(agent.MemoryBytes(), std::size_t{8} << 20);
  EXPECT_THAT(std::string(agent.breakdown()), testing::HasSubstr("make ever longer texts"));
}

TEST(AgentMemory, ElementsThatAreAddedWithinOneDecisionAreLimited) {
  Agent agent("collector");
  agent.mutable_settings().max_elaborations = 10'000'000;
  agent.mutable_settings().most_memory_bytes = std::size_t{4} << 20;
  for (const char* rule : {"start (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name count)",
                           "zero (state <s> ^operator.name count -^n) --> (<s> ^n 0)",
                           "count (state <s> ^operator.name count ^n <n>) --> (<s> ^n (+ <n> 1) <n> - ^seen <n>)"}) {
    ASSERT_TRUE(agent.LoadProduction(rule).loaded);
  }
  agent.Run(RunUnit::kDecision, 2);
  EXPECT_TRUE(agent.out_of_memory());
  EXPECT_LT(agent.MemoryBytes(), std::size_t{8} << 20);
  EXPECT_THAT(std::string(agent.breakdown()), testing::HasSubstr("add elements without end"));
}

TEST(AgentMemory, PartialMatchesThatAreKeptApartAreLimitedToo) {
  // Hardly any pair joins with the last condition: pairs that arrive late are parked.
  Agent agent("greedy");
  agent.mutable_settings().max_partial_matches = 20000;
  for (const char* side : {"left", "right"}) {
    std::string values = std::string(side) + " (state <s> ^superstate nil) --> (<s> ^" + side;
    for (int value = 0; value < 400; ++value) values += " " + std::to_string(value);
    ASSERT_TRUE(agent.LoadProduction(values + ")").loaded);
  }
  ASSERT_TRUE(agent.LoadProduction("join (state <s> ^left <a> ^right <b> ^<a> <b>) --> (<s> ^all yes)").loaded);
  agent.Run(RunUnit::kDecision, 2);
  EXPECT_TRUE(agent.out_of_memory());
  EXPECT_THAT(std::string(agent.breakdown()), testing::EndsWith("'soar max-partial-matches' allows 20000 in all"));
  EXPECT_EQ(agent.rete().statistics().tokens, 0u) << "what they took is given back";
}

// Levels --------------------------------------------------------------------------------------------------------------

TEST_F(AgentTest, WhatTheArchitecturePutsIntoAnObjectGoesUpWithIt) {
  Load("propose (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name wait)");
  Load("keep (state <s> ^superstate <top> ^epmem <e>) (<top> ^superstate nil) --> (<top> ^kept <e>)");
  agent.Run(RunUnit::kDecision, 3);
  const Symbol memory = agent.memory().ValueOf(Top(), Text("kept"));
  ASSERT_TRUE(memory.IsIdentifier());
  EXPECT_EQ(agent.memory().level(memory), 1);
  EXPECT_EQ(agent.memory().level(agent.memory().ValueOf(memory, Text("command"))), 1);
  EXPECT_EQ(agent.CheckInvariants(), "");
}

// Large slots ---------------------------------------------------------------------------------------------------------

TEST_F(AgentTest, AFactThatIsThereAlreadyIsNotAddedAgainToALargeSlot) {
  Load("init (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name init)");
  std::string one = "one (state <s> ^operator.name init) --> (<s> ^part <s> <a> <b>";
  for (int value = 0; value < 397; ++value) one += " " + std::to_string(value);
  Load(one + ")");
  Load("two (state <s> ^operator.name init ^io.input-link.step 2 ^part <p>) --> (<s> ^part <p>)");
  Load("three (state <s> ^operator.name init ^io.input-link.step 3 ^part { <p> > 9 }) --> (<s> ^part <p> -)");
  Load("four (state <s> ^operator.name init ^io.input-link.step 4) --> (<s> ^part 300 9)");
  std::vector<std::uint32_t> counts;
  for (std::int64_t step = 1; step <= 4; ++step) {
    agent.input().Add(InputObject::kInputLink, "step", step);
    agent.Run(RunUnit::kDecision, 2);
    counts.push_back(agent.memory().slot(agent.memory().FindSlot(Top(), Text("part"))).acceptable_count);
    EXPECT_EQ(agent.CheckInvariants(), "");
  }
  EXPECT_EQ(counts, (std::vector<std::uint32_t>{400, 400, 13, 14}));
}

// Sharing ---------------------------------------------------------------------------------------------------------

TEST(AgentSharing, AgentsWithEqualRulesHoldOneCopyAndPartWhenOneChangesItsRules) {
  const std::vector<std::string> rules = {"a (state <s> ^superstate nil ^io.input-link.x <x>) --> (<s> ^seen <x>)",
                                          "b (state <s> ^seen 1) --> (<s> ^operator <o> +) (<o> ^name one)"};
  Agent first("first"), second("second");
  for (Agent* agent : {&first, &second}) {
    for (const std::string& rule : rules) ASSERT_TRUE(agent->LoadProduction(rule).loaded);
    agent->input().Add(InputObject::kInputLink, "x", std::int64_t{1});
    agent->Run(RunUnit::kDecision, 1);
  }
  EXPECT_EQ(first.rete().network(), second.rete().network());
  ASSERT_TRUE(second.LoadProduction("c (state <s> ^seen 1) --> (<s> ^more yes)").loaded);
  EXPECT_NE(first.rete().network(), second.rete().network());
  for (Agent* agent : {&first, &second}) {
    agent->Run(RunUnit::kDecision, 1);
    EXPECT_EQ(agent->CheckInvariants(), "");
    EXPECT_EQ(agent->counters().firings, agent == &first ? 2u : 3u);
  }
}

}  // namespace
}  // namespace soarbox::kernel
