// SPDX-License-Identifier: BSD-2-Clause
// A recording contains the run, byte for byte; every difference from it is found and reported.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "record/reader.h"
#include "record/recorder.h"
#include "record/rerun.h"
#include "record/run_test_support.h"
#include "record/ticks_test_support.h"
#include "sim/simulation.h"
#include "world/world.h"

namespace soarbox::record {
namespace {

using Change = std::function<void(TickRecord&)>;
using Meddle = std::function<void(sim::Simulation&)>;

/// Runs a scenario and records it; `change` modifies the recorded data, `meddle` the run.
std::vector<TickRecord> RunAndRecord(const std::filesystem::path& file, const std::string& name, int ticks,
                                     const Change& change = {}, const Meddle& meddle = {}) {
  const sim::Scenario scenario = sim::FindScenario(name, Data()).value();
  sim::SimulationSettings settings;
  settings.seed = 3;
  settings.soar.threads = 1;
  settings.mind_detail = DetailOf(Level::kAll);
  const std::unique_ptr<sim::Simulation> simulation = std::move(sim::Simulation::Create(scenario, settings).value());
  Header header = HeaderOf(scenario, settings, static_cast<double>(simulation->world().settings().step_s), Level::kAll);
  header.scenario = name;
  Recorder recorder(std::move(Writer::Create(file, header, {.ticks_per_block = 10}).value()), Level::kAll);
  std::vector<TickRecord> live;
  while (true) {
    TickRecord record;
    const sim::EventList events = simulation->TakeEvents();
    Observe(*simulation, events, Level::kAll, record);
    if (change) change(record);
    live.push_back(record);
    EXPECT_TRUE(change ? recorder.Take(std::move(record)) : recorder.Take(*simulation, events));
    if (simulation->tick() >= static_cast<std::uint64_t>(ticks)) break;
    if (meddle) meddle(*simulation);
    simulation->Tick();
  }
  EXPECT_TRUE(recorder.Finish());
  return live;
}

Verdict VerdictOn(const std::filesystem::path& file, int threads = 1) {
  const Result<std::unique_ptr<Reader>> reader = Reader::Open(file);
  EXPECT_TRUE(reader) << Format(reader.error());
  const Result<Verdict> verdict = Verify(**reader, Data(), {}, threads);
  EXPECT_TRUE(verdict) << Format(verdict.error());
  return *verdict;
}

/// Checks that the file contains each tick as it ran, and that repeated runs with other numbers of threads are the
/// same.
void ExpectEqualBytes(const std::string& name, std::uint64_t ticks, std::vector<int> thread_counts) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "run";
  const std::vector<TickRecord> live = RunAndRecord(file, name, static_cast<int>(ticks));
  const Result<std::unique_ptr<Reader>> reader = Reader::Open(file);
  ASSERT_TRUE(reader) << Format(reader.error());
  ASSERT_EQ((*reader)->last_tick(), ticks);
  for (std::uint64_t tick = 0; tick <= ticks; ++tick)
    ASSERT_EQ(Bytes(**(*reader)->At(tick)), Bytes(live[tick])) << name << " " << tick;
  for (const int threads : thread_counts) {
    Result<Rerun> rerun = Restart(**reader, Data(), {.threads = threads});
    ASSERT_TRUE(rerun) << Format(rerun.error());
    EXPECT_TRUE(rerun->warnings.empty());
    TickRecord now;
    for (std::uint64_t tick = 0; tick <= ticks; ++tick) {
      if (tick > 0) rerun->simulation->Tick();
      Observe(*rerun->simulation, rerun->simulation->TakeEvents(), Level::kAll, now);
      ASSERT_EQ(Bytes(now), Bytes(live[tick])) << name << " " << tick << ", threads: " << threads;
    }
  }
}

TEST(Verify, ARecordingIsTheRunByteByByteAndSoIsTheRunOnceMore) {
  for (const char* name : {"crowd/crowd_10.lua", "soar_skirmish"}) ExpectEqualBytes(name, 24, {1, 4});
}

// If the kernel's invariants are checked after each phase, a tick of a fight takes more than a second.
#ifdef SOARBOX_CHECK_INVARIANTS
constexpr int kTicksOfEach = 20;
#else
constexpr int kTicksOfEach = 60;
#endif

class EveryScenario : public testing::TestWithParam<std::string> {};

TEST_P(EveryScenario, IsRecordedAndRunsOnceMoreByteByByte) {
  ExpectEqualBytes(GetParam(), kTicksOfEach, {2});
}

INSTANTIATE_TEST_SUITE_P(Verify, EveryScenario, testing::ValuesIn(sim::ListScenarios(Data())),
                         [](const auto& scenario) {
                           std::string name = scenario.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Verify, OneBitOfAStateIsFoundAndNamed) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "run";
  RunAndRecord(file, "crowd/crowd_10.lua", 20, [](TickRecord& record) {
    if (record.tick == 13) record.state_hash ^= 1;
  });
  const Verdict verdict = VerdictOn(file);
  ASSERT_TRUE(verdict.difference);
  EXPECT_EQ(verdict.difference->tick, 13u);
  EXPECT_EQ(verdict.difference->element, "the state's hash");
}

/// Changes an event of this kind.
template <typename Kind, typename Change>
std::function<bool(mind::Event&)> ChangeOf(Change change) {
  return [change](mind::Event& event) {
    Kind* const wanted = std::get_if<Kind>(&event);
    if (wanted != nullptr) change(*wanted);
    return wanted != nullptr;
  };
}

/// Changes the first event that can be changed.
bool ChangeOne(mind::EventLog& events, const std::function<bool(mind::Event&)>& change) {
  mind::EventLog changed;
  bool is_changed = false;
  mind::Event event;
  for (std::size_t at = 0; events.Next(at, event);) {
    is_changed = is_changed || change(event);
    std::visit([&](const auto& each) { changed.Add(each); }, event);
  }
  events = changed;
  return is_changed;
}

TEST(Verify, WhatIsSeenOrThoughtOtherwiseIsNamedWithItsAgent) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "run";
  std::string agent;
  RunAndRecord(file, "crowd/crowd_10.lua", 15, [&](TickRecord& record) {
    if (record.tick != 11) return;
    agent = record.scene.agents[2].name;
    record.scene.agents[2].position.x += 1e-5f;
  });
  Verdict verdict = VerdictOn(file);
  ASSERT_TRUE(verdict.difference);
  EXPECT_EQ(verdict.difference->agent, agent);
  EXPECT_EQ(verdict.difference->element, "position");

  const std::pair<const char*, std::function<bool(mind::Event&)>> parts[] = {
      {"percepts", ChangeOf<mind::PerceptChanged>([](auto& percept) { percept.attribute = "x"; })},
      {"decisions", ChangeOf<mind::OperatorSelected>([](auto& selected) { selected.name = "x"; })},
      {"reasons", ChangeOf<mind::OperatorSelected>([](auto& selected) { selected.decision = {}; })},
      {"commands", ChangeOf<mind::CommandSaid>([](auto& said) { said.name = "x"; })}};
  for (const auto& [element, change] : parts) {
    RunAndRecord(file, "crowd/crowd_10.lua", 15, [&, change = change](TickRecord& record) {
      if (record.tick != 11) return;
      for (MindRecord& mind : record.minds) {
        if (!ChangeOne(mind.events, change)) continue;
        agent = mind.agent;
        return;
      }
      ADD_FAILURE() << "no mind has any";
    });
    verdict = VerdictOn(file);
    ASSERT_TRUE(verdict.difference) << element;
    EXPECT_EQ(verdict.difference->tick, 11u);
    EXPECT_EQ(verdict.difference->agent, agent);
    EXPECT_EQ(verdict.difference->element, element);
  }
}

TEST(Verify, OneRandomNumberIsFound) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "run";
  // One random number is drawn that the recording does not contain.
  RunAndRecord(
      file, "crowd/crowd_10.lua", 15, [](TickRecord& record) { record.inputs.clear(); },
      [](sim::Simulation& simulation) {
        if (simulation.tick() == 7) simulation.Submit(sim::ScriptInput{"", "math.random()"});
      });
  const Verdict verdict = VerdictOn(file);
  ASSERT_TRUE(verdict.difference);
  EXPECT_EQ(verdict.difference->tick, 8u);
}

TEST(Verify, UnchangedIsEqualOnAnyNumberOfThreads) {
  const ScratchFolder scratch;
  const std::filesystem::path file = scratch.path() / "run";
  RunAndRecord(file, "crowd/crowd_10.lua", 20, {}, [](sim::Simulation& simulation) {
    if (simulation.tick() == 7) simulation.Submit(sim::ScriptInput{"", "math.random()"});
  });
  for (const int threads : {1, 4}) {
    const Verdict verdict = VerdictOn(file, threads);
    EXPECT_FALSE(verdict.difference) << verdict.difference->element;
    EXPECT_EQ(verdict.last_tick, 20u);
  }
}

}  // namespace
}  // namespace soarbox::record
