// SPDX-License-Identifier: BSD-2-Clause
#include "mission/evaluator.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <random>

#include "mission/check_sentences.h"
#include "mission/child_pool.h"
#include "mission/read_mission.h"
#include "mission/scenario_names.h"
#include "mission/statistics.h"

namespace soarbox::mission {
namespace {

Mission Read(const std::string& checks) {
  std::vector<Diagnostic> problems;
  Mission mission = ParseMission("scenario = \".\"\n" + checks, "mission.toml", false, problems);
  for (const Diagnostic& problem : problems) ADD_FAILURE() << Format(problem);
  return mission;
}

std::string ProblemOf(const std::string& checks) {
  std::vector<Diagnostic> problems;
  (void)ParseMission("scenario = \".\"\n" + checks, "mission.toml", false, problems);
  return problems.empty() ? std::string() : std::to_string(problems.front().line) + ": " + problems.front().message;
}

/// One agent that moves from x = 0 along a line at one metre per second, with a gate at x = 10.
TickFacts At(int tick) {
  TickFacts facts;
  facts.tick = static_cast<std::uint64_t>(tick);
  facts.time_s = tick / 30.0;
  facts.waypoints = {{"gate", {10, 0, 0}, 0, 0, 0}};
  AgentFacts& scout = facts.agents.emplace_back();
  scout.name = "scout";
  scout.team = "blue";
  scout.position = {static_cast<float>(tick) / 30, 0, 0};
  scout.health = 100;
  scout.distance = tick / 30.0;
  return facts;
}

struct Outcome {
  std::vector<Verdict> verdicts;
  bool passed = false;
};

Outcome Play(const Mission& mission, int ticks, const std::function<void(TickFacts&)>& change = {}) {
  Evaluator evaluator(mission);
  for (int tick = 0; tick <= ticks; ++tick) {
    TickFacts facts = At(tick);
    if (change) change(facts);
    evaluator.Feed(facts);
  }
  evaluator.Finish();
  return {{evaluator.verdicts().begin(), evaluator.verdicts().end()}, evaluator.HasPassed()};
}

void Print(TickFacts& facts, int tick, const char* text) {
  if (facts.tick == static_cast<std::uint64_t>(tick))
    facts.agents[0].events.push_back({Key::kPrints, text, {}, {}, {}});
}

TEST(Evaluator, WhatComesTrueInTimeIsTrueAtThatMomentAndTooLateIsFalseWithTheClosestApproach) {
  const Mission mission = Read(
      "[[check]]\nagent = \"scout\"\nat = \"gate\"\nby = 9\n[[check]]\nagent = \"scout\"\nat = \"gate\"\nby = 8\n");
  const Outcome outcome = Play(mission, 300);
  EXPECT_EQ(outcome.verdicts[0].state, State::kTrue);
  EXPECT_NEAR(outcome.verdicts[0].time_s, 8.5, 0.04);
  EXPECT_EQ(outcome.verdicts[1].state, State::kFalse);
  EXPECT_EQ(outcome.verdicts[1].was, "it came within 2 m, at 8.0 s");
  EXPECT_FALSE(outcome.passed);
}

TEST(Evaluator, ForWantsItWithoutABreak) {
  const Mission mission = Read("[[check]]\nagent = \"scout\"\nhealth = { min = 50 }\nfor = 2\nfrom = 1\nby = 5\n");
  EXPECT_NEAR(Play(mission, 200).verdicts[0].time_s, 3, 0.05);
  const auto wounded = [](TickFacts& facts) { facts.agents[0].health = facts.tick % 45 == 0 ? 10 : 100; };
  EXPECT_EQ(Play(mission, 200, wounded).verdicts[0].state, State::kFalse);
}

TEST(Evaluator, AlwaysAndNeverAreDecidedAtTheFirstOffence) {
  const Mission mission = Read(
      "[[check]]\nagent = \"scout\"\nhealth = { min = 30 }\nalways = true\n[[check]]\nagent = \"scout\"\nprints = "
      "\"help*\"\nnever = true\n");
  const Outcome outcome = Play(mission, 100, [](TickFacts& facts) {
    if (facts.tick >= 60) facts.agents[0].health = 20;
    Print(facts, 90, "help me");
  });
  EXPECT_EQ(outcome.verdicts[0].state, State::kFalse);
  EXPECT_EQ(outcome.verdicts[0].tick, 60u);
  EXPECT_EQ(outcome.verdicts[0].was, "it was 20");
  EXPECT_EQ(outcome.verdicts[1].state, State::kFalse);
  EXPECT_EQ(outcome.verdicts[1].tick, 90u);
  EXPECT_TRUE(Play(mission, 100).passed);
}

TEST(Evaluator, AfterOpensAWindowAndWhatNeverOpensIsNotTested) {
  const Mission mission = Read(
      "[[check]]\nname = \"first\"\nagent = \"scout\"\nprints = \"a\"\n"
      "[[check]]\nname = \"then\"\nagent = \"scout\"\nprints = \"b\"\nafter = \"first\"\nwithin = 1\n");
  const auto prints = [](int second) {
    return [second](TickFacts& facts) {
      Print(facts, 30, "a");
      Print(facts, second, "b");
    };
  };
  EXPECT_TRUE(Play(mission, 120, prints(50)).passed);
  EXPECT_EQ(Play(mission, 120, prints(80)).verdicts[1].state, State::kFalse);
  EXPECT_EQ(Play(mission, 120, prints(20)).verdicts[1].state, State::kFalse) << "before it does not count";
  EXPECT_EQ(Play(mission, 120).verdicts[1].state, State::kUntested);
}

TEST(Evaluator, BeforeIsUntilTheOtherComesTrue) {
  const Mission mission = Read(
      "[[check]]\nname = \"order\"\nagent = \"scout\"\nprints = \"go\"\n"
      "[[check]]\nagent = \"scout\"\nprints = \"move\"\nbefore = \"order\"\nnever = true\n");
  EXPECT_TRUE(Play(mission, 90, [](TickFacts& facts) {
                Print(facts, 30, "go");
                Print(facts, 40, "move");
              }).passed);
  EXPECT_FALSE(Play(mission, 90, [](TickFacts& facts) {
                 Print(facts, 30, "go");
                 Print(facts, 20, "move");
               }).passed);
}

TEST(Evaluator, WheneverWantsAnAnswerToEachOccurrence) {
  const Mission mission = Read(
      "[[check]]\nname = \"call\"\nmarker = true\nagent = \"scout\"\nprints = \"who\"\n"
      "[[check]]\nagent = \"scout\"\nprints = \"me\"\nwhenever = \"call\"\nwithin = 1\n");
  const Outcome good = Play(mission, 200, [](TickFacts& facts) {
    Print(facts, 30, "who");
    Print(facts, 40, "me");
    Print(facts, 90, "who");
    Print(facts, 120, "me");
    Print(facts, 190, "who");
  });
  EXPECT_TRUE(good.passed) << "the last one is younger than a second";
  const Outcome bad = Play(mission, 200, [](TickFacts& facts) {
    Print(facts, 30, "who");
    Print(facts, 40, "me");
    Print(facts, 90, "who");
  });
  EXPECT_EQ(bad.verdicts[1].state, State::kFalse);
  EXPECT_EQ(bad.verdicts[1].tick, 121u);
}

TEST(Evaluator, TimesCountsEventsAndRisingEdgesAndCountersAreBounded) {
  const Mission mission = Read(
      "[[check]]\nagent = \"scout\"\nprints = \"x\"\ntimes = 2\n"
      "[[check]]\nagent = \"scout\"\nhealth = { max = 50 }\ntimes = { max = 1 }\n"
      "[[check]]\nagent = \"scout\"\ndistance = { max = 5 }\n"
      "[[check]]\nagent = \"scout\"\ndistance = { min = 2 }\n");
  const Outcome outcome = Play(mission, 180, [](TickFacts& facts) {
    Print(facts, 10, "x");
    Print(facts, 20, "x");
    if ((facts.tick > 30 && facts.tick < 40) || (facts.tick > 50 && facts.tick < 60)) facts.agents[0].health = 40;
  });
  EXPECT_EQ(outcome.verdicts[0].state, State::kTrue);
  EXPECT_EQ(outcome.verdicts[1].state, State::kFalse);
  EXPECT_EQ(outcome.verdicts[1].tick, 51u);
  EXPECT_EQ(outcome.verdicts[2].state, State::kFalse);
  EXPECT_NEAR(outcome.verdicts[2].time_s, 5, 0.05);
  EXPECT_EQ(outcome.verdicts[3].state, State::kTrue);
  EXPECT_NEAR(outcome.verdicts[3].time_s, 2, 0.05);
}

TEST(Evaluator, WhoSaysHowManyMustDoIt) {
  const auto two = [](TickFacts& facts) {
    AgentFacts other = facts.agents[0];
    other.name = "late";
    other.position.x -= 3;
    facts.agents.push_back(other);
  };
  const std::string at = "at = \"gate\"\nby = 9\n";
  EXPECT_FALSE(Play(Read("[[check]]\nteam = \"blue\"\n" + at), 300, two).passed);
  EXPECT_TRUE(Play(Read("[[check]]\nteam = \"blue\"\nwho = \"any\"\n" + at), 300, two).passed);
  EXPECT_FALSE(Play(Read("[[check]]\nteam = \"blue\"\nwho = \"together\"\nat = \"gate\"\n"), 300, two).passed);
  EXPECT_TRUE(Play(Read("[[check]]\nteam = \"blue\"\nat = \"gate\"\n"), 400, two).passed)
      << "each at a moment of its own";
}

TEST(Evaluator, WhatHoldsBeforeAnybodyActedTestsNothing) {
  const Mission mission = Read("[[check]]\nagent = \"scout\"\nhealth = { min = 1 }\nby = 5\n");
  Evaluator evaluator(mission);
  evaluator.Feed(At(0));
  EXPECT_EQ(evaluator.idle_checks(), std::vector<std::size_t>{0});
}

TEST(Evaluator, AKernelThatDoesNotTellLeavesChecksUndecided) {
  const Mission mission = Read("[[check]]\nagent = \"scout\"\nimpasse = \"tie\"\nnever = true\n");
  Evaluator evaluator(mission, false);
  for (int tick = 0; tick < 10; ++tick) evaluator.Feed(At(tick));
  evaluator.Finish();
  EXPECT_EQ(evaluator.verdicts()[0].state, State::kUndecided);
  EXPECT_FALSE(evaluator.HasPassed());
}

/// Compares with a simple judge of the basic checks, which stores every tick.
TEST(Evaluator, AgreesWithAJudgeThatKeepsEveryTick) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    const int by = static_cast<int>(random() % 4) + 1, from = static_cast<int>(random() % 4);
    std::vector<bool> holds(150);
    for (std::size_t i = 0; i < holds.size(); ++i) holds[i] = random() % 60 == 0;
    const auto change = [&](TickFacts& facts) { facts.agents[0].health = holds[facts.tick] ? 10 : 90; };
    const std::string condition = "[[check]]\nagent = \"scout\"\nhealth = { max = 50 }\n";
    const std::string window = "from = " + std::to_string(from) + "\nto = " + std::to_string(from + by) + "\n";
    int count = 0;
    bool any = false;
    for (int tick = 0; tick < 150; ++tick) {
      const auto at = static_cast<std::size_t>(tick);
      if (!holds[at] || tick < from * 30 || tick > (from + by) * 30) continue;
      any = true;
      count += tick == 0 || !holds[at - 1] ? 1 : 0;
    }
    EXPECT_EQ(Play(Read(condition + window), 149, change).passed, any) << round;
    EXPECT_EQ(Play(Read(condition + "never = true\n" + window), 149, change).passed, !any) << round;
    EXPECT_EQ(Play(Read(condition + "times = { min = 1, max = 2 }\n" + window), 149, change).passed,
              count >= 1 && count <= 2)
        << round;
  }
}

TEST(ReadMission, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(ProblemOf("[[check]]\nagent = \"a\"\nat = \"g\"\nopreator = \"go\"\n"), "5: a check has no 'opreator'");
  EXPECT_EQ(ProblemOf("[[check]]\nat = \"gate\"\n"), "2: this check does not name the agent, team or item it is about");
  EXPECT_EQ(ProblemOf("[[check]]\nagent = \"a\"\n"), "2: this check does not say what must be true");
  EXPECT_EQ(ProblemOf("[[check]]\nagent = \"a\"\nhealth = 3\nby = 4\n"), "4: 'health' takes bounds");
  EXPECT_EQ(ProblemOf("[[check]]\nagent = \"a\"\nhealth = { min = 3 }\n"), "2: 'health' does not say when");
  EXPECT_EQ(ProblemOf("[[check]]\nagent = \"a\"\nat = \"g\"\nby = 4\nnever = true\n"), "5: 'never' has no 'by'");
  EXPECT_EQ(ProblemOf("[[check]]\nagent = \"a\"\nat = \"g\"\nafter = \"b\"\n"), "5: there is no check 'b'");
  EXPECT_EQ(ProblemOf("[[check]]\nagent = \"a\"\nprints = \"x\"\ncommand = \"stop\"\n").substr(3),
            "two events are two checks");
  EXPECT_EQ(ProblemOf("[[check]]\nname = \"x\"\nagent = \"a\"\nat = \"g\"\nafter = \"y\"\n[[check]]\nname = "
                      "\"y\"\nagent = \"a\"\nat = \"g\"\nafter = \"x\"\n"),
            "6: these checks wait for each other: 'after' goes in a circle");
  EXPECT_EQ(ProblemOf("[[check]]\nagent = \"a\"\nnear = \"g\"\n"), "2: 'near' needs a range");
}

TEST(ReadMission, NamesThatNothingKnowsAreRefusedWithWhatWasMeant) {
  const Mission mission =
      Read("[[check]]\nagent = \"scuot\"\nat = \"gtae\"\n[[check]]\nteam = \"rde\"\nimpasse = \"tei\"\nnever = true\n");
  Cast cast;
  cast.agents = {"scout"};
  cast.teams = {"red"};
  cast.waypoints = {"gate"};
  std::vector<Diagnostic> problems;
  CheckNames(mission, cast, problems);
  ASSERT_EQ(problems.size(), 4u);
  EXPECT_EQ(problems[0].message, "there is no agent 'scuot'");
  EXPECT_EQ(problems[0].hint, "did you mean 'scout'?");
  EXPECT_EQ(problems[1].message, "there is no waypoint 'gtae'");
  EXPECT_EQ(problems[1].line, 4);
  EXPECT_EQ(problems[2].message, "there is no team 'rde'");
  EXPECT_EQ(problems[3].message, "there is no impasse 'tei'");
}

TEST(Sentences, WhatDidNotHoldIsSaidAsPeopleSayIt) {
  EXPECT_EQ(Denied("give move-to"), "it did not give move-to");
  EXPECT_EQ(Denied("be at gate"), "it was not at gate");
  EXPECT_EQ(Denied("not be carried"), "it was carried");
}

TEST(Seeds, AreListsAndRanges) {
  EXPECT_EQ(ParseSeeds("1..3,7"), (std::vector<std::uint64_t>{1, 2, 3, 7}));
  EXPECT_EQ(ParseSeeds("3..1"), std::nullopt);
  EXPECT_EQ(ParseSeeds("1..99999999999"), std::nullopt);
  EXPECT_EQ(ParseSeeds("x"), std::nullopt);
}

TEST(Statistics, AgreeWithPublishedValues) {
  const Interval all = WilsonInterval(20, 20);
  EXPECT_NEAR(all.low, 0.8389, 0.0005);
  EXPECT_EQ(all.high, 1);
  const Interval some = WilsonInterval(18, 20);
  EXPECT_NEAR(some.low, 0.6990, 0.0005);
  EXPECT_NEAR(some.high, 0.9721, 0.0005);
  EXPECT_NEAR(McNemar(1, 9), 0.021484375, 1e-9);
  EXPECT_NEAR(McNemar(5, 5), 1, 1e-9);
  const std::vector<double> values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_NEAR(Mean(values), 5.5, 1e-12);
  EXPECT_EQ(Median(values), 5.5);
}

TEST(ChildPool, AChildThatCrashesOrHangsCostsItsWorkOnly) {
  ChildPool pool(3);
  ChildLimits limits;
  limits.cpu_s = 1;
  ASSERT_TRUE(pool.Start(
                      0, [] { return std::string("good"); }, limits)
                  .ok());
  ASSERT_TRUE(pool.Start(
                      1, []() -> std::string { std::abort(); }, limits)
                  .ok());
  ASSERT_TRUE(pool.Start(
                      2,
                      []() -> std::string {
                        volatile bool goes_on = true;
                        while (goes_on) {
                        }
                        return {};
                      },
                      limits)
                  .ok());
  int seen = 0;
  while (!pool.IsIdle()) {
    const auto done = pool.Wait(20);
    if (!done) continue;
    ++seen;
    EXPECT_EQ(done->end.is_whole, done->id == 0);
    EXPECT_EQ(done->end.output, done->id == 0 ? "good" : "");
    EXPECT_EQ(done->end.signal == SIGABRT, done->id == 1);
    EXPECT_EQ(done->end.hung, done->id == 2);
  }
  EXPECT_EQ(seen, 3);
}

}  // namespace
}  // namespace soarbox::mission
