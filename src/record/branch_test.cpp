// SPDX-License-Identifier: BSD-2-Clause
// Branches of worlds with running minds.
#include "record/branch.h"

#include <gtest/gtest.h>

#include <fstream>

#include "record/history.h"
#include "record/reader.h"
#include "record/recorder.h"
#include "record/run_test_support.h"
#include "record/ticks_test_support.h"
#include "record/writer.h"
#include "sim/simulation.h"
#include "world/world.h"

namespace soarbox::record {
namespace {

namespace fs = std::filesystem;

/// A run with its history, as a window has one.
struct LiveRun : NotedRun {
  LiveRun(const std::string& name, int threads) {
    scenario = sim::FindScenario(name, Data()).value();
    settings.seed = 7;
    settings.soar.threads = threads;
    settings.mind_detail = DetailOf(Level::kDecisions);
    simulation = std::move(sim::Simulation::Create(scenario, settings).value());
    header =
        HeaderOf(scenario, settings, static_cast<double>(simulation->world().settings().step_s), Level::kDecisions);
    header.scenario = name;
    history = std::make_unique<History>(header, HistorySettings{.ticks_per_block = 10});
    Note();
  }

  Header header;
};

/// Advances a branch to its goal in slices of five ticks.
void Arrive(Branch& branch) {
  while (!branch.IsThere()) {
    const std::uint64_t before = branch.tick();
    const Result<void> gone = branch.Advance(5);
    ASSERT_TRUE(gone) << Format(gone.error());
    ASSERT_LE(branch.tick() - before, 5u);
  }
}

std::unique_ptr<Branch> Begin(LiveRun& run, std::uint64_t tick, int threads) {
  sim::SimulationSettings settings = run.settings;
  settings.soar.threads = threads;
  Result<std::unique_ptr<Branch>> branch = Branch::Begin(*run.history, run.scenario, settings, tick);
  EXPECT_TRUE(branch) << Format(branch.error());
  return std::move(*branch);
}

/// Continues with a branch and compares it with the old future.
Comparison GoOn(Branch& branch, int ticks) {
  Futures futures = branch.CompareFutures();
  const std::unique_ptr<sim::Simulation> simulation = branch.TakeSimulation();
  TickRecord record;
  for (int i = 0; i < ticks; ++i) {
    simulation->Tick();
    Observe(*simulation, simulation->TakeEvents(), Level::kDecisions, record);
    futures.See(record);
  }
  return futures.comparison();
}

TEST(Branch, WithoutAChangeTheFutureIsTheSameOnAnyNumberOfThreads) {
  LiveRun run("crowd/crowd_10.lua", 1);
  // A script is edited in the meantime. The edit is then part of the past.
  run.Run(12);
  run.simulation->Submit(sim::ScriptInput{"", "Sandbox.CreateObject = Sandbox.CreateObject"});
  run.Run(28);
  for (const int threads : {1, 4}) {
    for (const std::uint64_t tick : {0u, 11u, 25u}) {
      const std::unique_ptr<Branch> branch = Begin(run, tick, threads);
      Arrive(*branch);
      EXPECT_EQ(branch->simulation().tick(), tick);
      EXPECT_EQ(branch->simulation().StateHash(), run.history->At(tick).value()->state_hash);
      EXPECT_TRUE(branch->warnings().empty());
      // Inputs after the branch are not applied again.
      EXPECT_EQ(branch->simulation().waiting_inputs(), 0u);
      if (tick < 13) continue;
      const Comparison comparison = GoOn(*branch, 15);
      EXPECT_FALSE(comparison.difference) << comparison.difference->element;
      EXPECT_EQ(comparison.first_tick, tick + 1);
      EXPECT_EQ(comparison.last_tick, 40u);
    }
  }
}

TEST(Branch, WithAChangedRuleItIsToldWhereTheFuturesPart) {
  LiveRun run("crowd/crowd_10.lua", 1);
  run.Run(40);
  const std::string agent = run.simulation->Mind(3).agent;
  for (const int threads : {1, 4}) {
    const std::unique_ptr<Branch> branch = Begin(run, 20, threads);
    Arrive(*branch);
    branch->simulation().Submit(sim::CommandInput{agent, "sp {stop*here (state <s> ^superstate nil) --> (halt)}"});
    const Comparison comparison = GoOn(*branch, 20);
    ASSERT_TRUE(comparison.difference);
    EXPECT_EQ(comparison.difference->tick, 21u);
    ASSERT_TRUE(comparison.decision);
    EXPECT_EQ(comparison.decision->agent, agent);
    EXPECT_FALSE(comparison.course.empty());
  }
}

TEST(Branch, TheOldFutureStaysAsGhosts) {
  LiveRun run("crowd/crowd_10.lua", 1);
  run.Run(30);
  const std::unique_ptr<Branch> branch = Begin(run, 10, 1);
  Arrive(*branch);
  Futures futures = branch->CompareFutures();
  ASSERT_NE(futures.Old(29), nullptr);
  EXPECT_EQ(Bytes(*futures.Old(29)), Bytes(**run.history->At(29)));
  EXPECT_EQ(futures.Old(31), nullptr);
  EXPECT_EQ(run.history->last_tick(), 30u);
}

TEST(Branch, LeavesFromTicksThatHaveNoRecordAnyMore) {
  LiveRun run("crowd/crowd_10.lua", 1);
  run.history = std::make_unique<History>(run.header, HistorySettings{.most_ticks = 10, .ticks_per_block = 10});
  run.Run(45);
  ASSERT_GT(run.history->first_tick(), 20u);
  const std::unique_ptr<Branch> branch = Begin(run, 20, 1);
  Arrive(*branch);
  const std::unique_ptr<sim::Simulation> simulation = branch->TakeSimulation();
  while (simulation->tick() < 45) simulation->Tick();
  EXPECT_EQ(simulation->StateHash(), run.simulation->StateHash());
}

TEST(Branch, AnotherSeedIsFoundAndNamed) {
  LiveRun run("crowd/crowd_10.lua", 1);
  run.Run(40);
  run.settings.seed = 8;
  Result<std::unique_ptr<Branch>> branch = Branch::Begin(*run.history, run.scenario, run.settings, 35);
  if (branch) {
    Result<void> gone;
    while (gone && !(*branch)->IsThere()) gone = (*branch)->Advance(5);
    ASSERT_FALSE(gone);
    EXPECT_NE(gone.error().message.find("at tick 3"), std::string::npos) << gone.error().message;
  } else {
    EXPECT_NE(branch.error().message.find("at tick 0"), std::string::npos) << branch.error().message;
  }
  EXPECT_FALSE(Branch::Begin(*run.history, run.scenario, run.settings, 41));
}

TEST(Branch, ComesFromARecordingToo) {
  const ScratchFolder scratch;
  LiveRun run("crowd/crowd_10.lua", 1);
  run.Run(30);
  {
    Result<std::unique_ptr<Writer>> writer = Writer::Create(scratch.path() / "run", run.header);
    ASSERT_TRUE(writer);
    for (std::uint64_t tick = 0; tick <= 30; ++tick) ASSERT_TRUE((*writer)->Add(**run.history->At(tick)));
  }
  const Result<std::unique_ptr<Reader>> reader = Reader::Open(scratch.path() / "run");
  ASSERT_TRUE(reader);
  for (const int threads : {1, 4}) {
    Result<std::unique_ptr<Branch>> branch = Branch::Begin(**reader, Data(), 15, threads);
    ASSERT_TRUE(branch) << Format(branch.error());
    Arrive(**branch);
    EXPECT_FALSE(GoOn(**branch, 15).difference);
  }
}

}  // namespace
}  // namespace soarbox::record
