// SPDX-License-Identifier: BSD-2-Clause
// The pace of a run in a window, and runs that restart; needs no display.
#include "app/window/run_commands.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <thread>

#include "app/event_printer.h"
#include "app/mind_steps.h"
#include "app/next_run.h"
#include "app/record_run.h"
#include "app/run_session.h"
#include "record/compare.h"
#include "record/reader.h"
#include "record/rerun.h"
#include "record/ticks_test_support.h"
#include "sim/scenario.h"
#include "workbench/pace.h"
#include "workbench/time_machine.h"
#include "world/world.h"

namespace soarbox::app {
namespace {

using workbench::Flow;
using workbench::Pace;
using workbench::TimeMachine;

constexpr double kStep_s = 1.0 / 30;

TEST(Pace, CatchesUpAfterASlowFrameButNotForever) {
  Pace pace(1);
  pace.TicksDue(kStep_s);
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  const int after_slow = pace.TicksDue(kStep_s);
  EXPECT_GE(after_slow, 4) << "the world waits for frames";
  EXPECT_LE(after_slow, 8);
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  EXPECT_LE(pace.TicksDue(kStep_s), 8) << "no more than a quarter of a second";
}

TEST(Pace, PausesStepsAndChangesSpeed) {
  Pace pace(1);
  pace.Obey(Flow::kStepTick);
  EXPECT_TRUE(pace.paused());
  EXPECT_EQ(pace.TicksDue(kStep_s), 1);
  EXPECT_EQ(pace.TicksDue(kStep_s), 0);
  pace.Obey(Flow::kTogglePause);
  EXPECT_FALSE(pace.paused());
  for (int i = 0; i < 20; ++i) pace.Obey(Flow::kSlower);
  EXPECT_EQ(pace.speed(), 0.1);
  for (int i = 0; i < 20; ++i) pace.Obey(Flow::kFaster);
  EXPECT_EQ(pace.speed(), 16);
  pace.Obey(Flow::kUnlimited);
  EXPECT_TRUE(std::isinf(pace.speed()));
  EXPECT_GT(pace.TicksDue(kStep_s), 1'000'000);
  // On a busy machine, much time may pass between two lines.
  bool had_time = false;
  for (int tries = 0; tries < 1000 && !had_time; ++tries) {
    pace.TicksDue(kStep_s);
    had_time = !pace.OutOfTime();
  }
  EXPECT_TRUE(had_time);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  EXPECT_TRUE(pace.OutOfTime()) << "the window would not answer";
  pace.Obey(Flow::kUnlimited);
  EXPECT_EQ(pace.speed(), 16);
  pace.Obey(Flow::kNormalSpeed);
  EXPECT_EQ(pace.speed(), 1);
  pace.Obey(Flow::kStepDecision);
  EXPECT_TRUE(pace.paused()) << "the world stands still while a mind takes a step";
  EXPECT_EQ(pace.TicksDue(kStep_s), 0);
}

TEST(Pace, AStepOfAGameGoesToTheEndOfItsTurn) {
  Pace pace(1);
  pace.Obey(Flow::kStepTurn);
  EXPECT_TRUE(pace.paused());
  EXPECT_EQ(pace.TicksDue(kStep_s, 0, 10), 10);
  pace.Obey(Flow::kStepTurn);
  EXPECT_EQ(pace.TicksDue(kStep_s, 13, 10), 7) << "somebody stopped within the turn";
  pace.Obey(Flow::kStepTurn);
  pace.Obey(Flow::kStepTurn);
  EXPECT_EQ(pace.TicksDue(kStep_s, 20, 10), 20);
  pace.Owe(4);
  EXPECT_EQ(pace.TicksDue(kStep_s, 36, 10), 4) << "the world was slow";
  EXPECT_EQ(pace.TicksDue(kStep_s, 40, 10), 0);
  pace.Obey(Flow::kStepTick);
  EXPECT_EQ(pace.TicksDue(kStep_s, 40, 10), 1);
  pace.Owe(1);
  EXPECT_EQ(pace.TicksDue(kStep_s, 41, 10), 0) << "who steps by ticks asks again";
  pace.Obey(Flow::kStepTurn);
  EXPECT_EQ(pace.TicksDue(kStep_s, 7, 1), 1) << "no turns";
}

/// A session for a scenario of the repository, as in a window.
struct SkirmishRun {
  explicit SkirmishRun(std::uint64_t seed) {
    const std::string root = SOARBOX_SOURCE_DIR;
    scenario = sim::FindScenario("soar_skirmish", {root + "/scenarios", root + "/media"}).value();
    const auto make = [this](std::uint64_t with_seed) {
      sim::SimulationSettings settings;
      settings.seed = settings.soar.seed = with_seed;
      settings.soar.threads = 1;
      return sim::Simulation::Create(scenario, settings);
    };
    session.emplace(std::move(make(seed).value()), EventPrinter::MakeText(out, out), RunOptions());
    session->SetMake(seed, scenario.name, make, [this] { ++times_made; });
  }
  std::uint64_t HashAfter(int ticks) {
    for (int i = 0; i < ticks; ++i) session->Tick();
    return session->simulation().StateHash();
  }

  sim::Scenario scenario;
  std::ostringstream out;
  int times_made = 0;
  std::optional<RunSession> session;
};

TEST(RunSession, BeginsAgainWithTheSameSeedOrTheNext) {
  SkirmishRun run(4);
  const std::uint64_t first = run.HashAfter(45);
  ASSERT_TRUE(run.session->BeginAgain(false));
  EXPECT_EQ(run.session->simulation().tick(), 0u);
  EXPECT_EQ(run.HashAfter(45), first) << "a reset is the same run";
  ASSERT_TRUE(run.session->BeginAgain(true));
  EXPECT_EQ(run.session->seed(), 5u);
  const std::uint64_t next = run.HashAfter(45);
  EXPECT_EQ(SkirmishRun(5).HashAfter(45), next) << "as if it had been started with that seed";
  EXPECT_EQ(run.times_made, 2);
}

TEST(RunSession, AMindCanTakeAStepAloneWhileTheWorldStandsStill) {
  SkirmishRun run(4);
  run.HashAfter(10);
  sim::Simulation& simulation = run.session->simulation();
  const std::uint64_t tick = simulation.tick();
  const auto decisions = [&] { return simulation.Inspect("blue-1")->Mind().decisions; };
  const auto others = [&] { return simulation.Inspect("red-1")->Mind().decisions; };
  const std::uint64_t before = decisions(), before_others = others();
  ASSERT_TRUE(simulation.Command("blue-1", "run -d 1 --self"));
  EXPECT_EQ(decisions(), before + 1);
  EXPECT_EQ(others(), before_others) << "the other minds stand still";
  EXPECT_EQ(simulation.tick(), tick);
  std::string phase = simulation.Inspect("blue-1")->Mind().phase;
  ASSERT_TRUE(simulation.Command("blue-1", "run -p 1 --self"));
  EXPECT_NE(simulation.Inspect("blue-1")->Mind().phase, phase);
  run.HashAfter(10);
  EXPECT_EQ(simulation.tick(), tick + 10);
}

TEST(RunSession, AStepOfADecisionPerceivesDecidesOnceAndTellsWhat) {
  SkirmishRun run(4);
  run.HashAfter(10);
  sim::Simulation& simulation = run.session->simulation();
  const auto decisions = [&] { return simulation.Inspect("blue-1")->Mind().decisions; };
  for (int i = 0; i < 5; ++i) {
    const std::uint64_t tick = simulation.tick(), before = decisions();
    const std::string told = StepMind(*run.session, "blue-1", MindStep::kDecision).told;
    EXPECT_EQ(simulation.tick(), tick + 1) << "new input comes with a tick";
    EXPECT_EQ(decisions(), before + 1) << told;
    EXPECT_TRUE(told.starts_with("blue-1: ")) << told;
  }
  const std::string budget = *simulation.Command("blue-1", "soar max-nil-output-cycles");
  EXPECT_EQ(budget, *simulation.Command("blue-2", "soar max-nil-output-cycles")) << "as it was before";
}

TEST(RunSession, WhatComesAfterGoingBackIsRecordedInAFileOfItsOwn) {
  const record::ScratchFolder scratch;
  const std::string root = SOARBOX_SOURCE_DIR;
  const sim::DataFolders data{root + "/scenarios", root + "/media"};
  RunOptions options;
  options.scenario = "soar_skirmish";
  options.record = scratch.path() / "fight.soarrec";
  const std::filesystem::path other = scratch.path() / "fight-2.soarrec";
  {
    SkirmishRun run(4);
    sim::SimulationSettings settings;
    settings.seed = settings.soar.seed = 4;
    const record::Header header =
        HeaderOfRun(options, run.scenario, settings, run.session->simulation(), record::Level::kDecisions);
    RunRecordings recordings(options);
    EXPECT_EQ(recordings.Begin(*run.session, header), "recording to " + options.record.string());
    TimeMachine past(header, run.scenario, settings);
    run.session->Watch([&](const record::TickRecord& tick) { past.Add(tick); });
    std::string told;
    run.session->SetOnBranch([&](const record::TickRecord& at, const std::vector<record::TickInputs>& inputs) {
      told = recordings.GoOn(*run.session, header, at, inputs);
    });
    run.session->simulation().Submit(sim::OrderInput{"blue-1", "hold here"});
    run.HashAfter(40);
    past.Seek(20);
    while (past.rebuilt().world() == nullptr) past.rebuilt().Advance(1);
    std::unique_ptr<sim::Simulation> simulation = past.Resume();
    run.session->GoOnWith(std::move(simulation), past.parting()->record, past.parting()->inputs);
    EXPECT_EQ(told, "recording to " + other.string());
    run.HashAfter(10);
    run.session->Watch({});
  }
  const Result<std::unique_ptr<record::Reader>> first = record::Reader::Open(options.record);
  const Result<std::unique_ptr<record::Reader>> second = record::Reader::Open(other);
  ASSERT_TRUE(first) << Format(first.error());
  ASSERT_TRUE(second) << Format(second.error());
  EXPECT_EQ((*first)->last_tick(), 40u);
  EXPECT_TRUE((*first)->header().branched_from.empty());
  EXPECT_EQ((*second)->first_tick(), 20u);
  EXPECT_EQ((*second)->last_tick(), 30u);
  EXPECT_EQ((*second)->header().branched_from, options.record.string());
  EXPECT_EQ((*second)->header().branch_tick, 20u);
  // Nothing was changed, so both continuations are equal; and the second recording is complete enough to be run again.
  const Result<record::Comparison> compared = record::Compare(**first, **second);
  ASSERT_TRUE(compared) << Format(compared.error());
  EXPECT_FALSE(compared->difference) << compared->difference->element;
  EXPECT_EQ((*second)->Inputs().value().size(), 1u) << "what came in before the branch";
  const Result<record::Verdict> verdict = record::Verify(**second, data);
  ASSERT_TRUE(verdict) << Format(verdict.error());
  EXPECT_FALSE(verdict->difference) << verdict->difference->element;
  EXPECT_EQ(verdict->last_tick, 30u);
}

TEST(NextRun, IsAScenarioOrARecordingOrNothingThatIsThere) {
  EXPECT_FALSE(FindNextRun("soar_seek")->is_recording);
  const Result<NextRun> none = FindNextRun("no_such_world");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("no_such_world"), std::string::npos);
  EXPECT_FALSE(FindNextRun("/no/such.soarrec"));
  EXPECT_FALSE(TakeNextRun());
  KeepNextRun({"soar_seek", false, 3});
  EXPECT_EQ(TakeNextRun()->script_line, 3U);
  EXPECT_FALSE(TakeNextRun()) << "once";
}

}  // namespace
}  // namespace soarbox::app
