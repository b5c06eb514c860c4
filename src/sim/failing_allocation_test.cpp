// SPDX-License-Identifier: BSD-2-Clause
// Each allocation of a world's step fails in turn. Only std::bad_alloc may be thrown, and the world must be
// destructible in any state.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <new>

#include "diagnostics/counted_allocations.h"
#include "sim/simulation.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRules = R"(
sp {go (state <s> ^superstate nil ^io <io>) (<io> ^input-link.time <t> ^output-link <out>)
   --> (<s> ^operator <o> + =) (<o> ^name turn ^at <t>)}
sp {turn (state <s> ^operator.name turn ^io.output-link <out>) --> (<out> ^turn-by <w> ^broadcast <b>) (<w> ^angle 1)
   (<b> ^about contact)}
)";
constexpr const char* kScenario = R"(
[[agent]]
name = "first"
rules = "rules.soar"
body = "soldier"
[[agent]]
name = "second"
rules = "rules.soar"
body = "soldier"
position = [3, 0]
)";

TEST(FailingAllocation, LeavesAWorldThatCanBeDestroyed) {
  const fs::path folder = fs::path(testing::TempDir()) / ("failing-" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "rules.soar") << kRules;
  std::ofstream(folder / "scenario.toml") << kScenario;
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = FindScenario(folder.string(), {root + "/scenarios", root + "/media"});
  ASSERT_TRUE(scenario.ok());
  SimulationSettings settings;
  settings.soar.threads = 1;
  const auto make = [&] {
    auto made = Simulation::Create(*scenario, settings);
    for (int i = 0; i < 3; ++i) (*made)->Tick();
    return std::move(*made);
  };
  const auto step = [](Simulation& world) {
    world.Tick();
    world.TakeEvents();
    static_cast<void>(world.Snapshot());
  };
  std::unique_ptr<Simulation> world = make();
  const std::int64_t before = allocations::Count();
  step(*world);
  const std::int64_t count = allocations::Count() - before;
  ASSERT_GT(count, 20);
  // Creating a world takes longer than a step, so only a sample of the allocations fails.
  constexpr std::int64_t kMostTries = 150;
  const std::int64_t stride = std::max<std::int64_t>(1, count / kMostTries);
  int failures = 0, tries = 0;
  for (std::int64_t n = 0; n < count; n += stride) {
    ++tries;
    world = make();
    allocations::RefuseAfter(n, allocations::Refusal::kOnce);
    try {
      step(*world);
    } catch (const std::bad_alloc&) {
      ++failures;
    }
    allocations::Allow();
  }
  EXPECT_GT(failures, tries / 4);
  world.reset();
  fs::remove_all(folder);
}

}  // namespace
}  // namespace soarbox::sim
