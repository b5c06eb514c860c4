// SPDX-License-Identifier: BSD-2-Clause
// Minds decide on several threads; the run is the same on any number of them.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "sim/simulation.h"
#include "sim/worker_pool.h"

namespace soarbox::sim {
namespace {

TEST(WorkerPool, EachRoundCallsEachNumberOnce) {
  for (const std::size_t threads : {1u, 2u, 5u}) {
    WorkerPool pool(threads);
    std::vector<int> calls(threads);
    for (int round = 0; round < 200; ++round) pool.Run([&](std::size_t number) { ++calls[number]; });
    EXPECT_EQ(calls, std::vector<int>(threads, 200));
  }
}

/// The hash of every tick.
std::vector<std::uint64_t> Play(const char* name, int threads, std::uint64_t seed, int ticks) {
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = FindScenario(name, {root + "/scenarios", root + "/media"});
  EXPECT_TRUE(scenario.ok());
  SimulationSettings settings;
  settings.seed = seed;
  settings.soar.threads = threads;
  auto simulation = Simulation::Create(scenario.value(), settings);
  EXPECT_TRUE(simulation.ok());
  // Minds without rules would be the same on any number of threads too.
  for (const Event& event : (*simulation)->TakeEvents())
    EXPECT_NE(event.diagnostic.severity == Severity::kError && !event.diagnostic.message.empty(), true)
        << Format(event.diagnostic);
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < ticks; ++i) {
    (*simulation)->Tick();
    hashes.push_back((*simulation)->StateHash());
  }
  return hashes;
}

TEST(Threads, TheRunIsTheSameOnAnyNumberOfThem) {
  // As many minds as threads share in one crowd, more of them but for fewer ticks in the other: with sanitizers and the
  // kernel's invariants checked, a decision costs a hundred times what it costs users.
  const std::pair<const char*, int> runs[] = {{"crowd/crowd_10.lua", 60}, {"crowd/crowd_100.lua", 8}, {"thesis", 30}};
  for (const auto& [name, ticks] : runs) {
    const auto one = Play(name, 1, 7, ticks);
    EXPECT_EQ(Play(name, 2, 7, ticks), one) << name;
    EXPECT_EQ(Play(name, 4, 7, ticks), one) << name;
    // The check can fail.
    EXPECT_NE(Play(name, 2, 8, ticks), one) << name;
  }
}

}  // namespace
}  // namespace soarbox::sim
