// SPDX-License-Identifier: BSD-2-Clause
// Memory runs out at each allocation of a world's step in turn: what throws is std::bad_alloc and nothing worse, and
// the world, in whatever state it was left, can be destroyed.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>

#include "sim/simulation.h"

// This program counts what it allocates, and refuses when it is told to: once, or each time from then on.
namespace {
constexpr std::int64_t kNever = -1;
std::int64_t allocations_left = kNever;
std::int64_t allocations = 0;
}  // namespace

// GCC 12 sees the inlined std::free, but not that this program's own operator new used std::malloc.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

void* operator new(std::size_t size) {
  if (allocations_left == 0) {
    allocations_left = kNever;
    throw std::bad_alloc();
  }
  if (allocations_left > 0) --allocations_left;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (!memory) throw std::bad_alloc();
  ++allocations;
  return memory;
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

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
  const std::int64_t before = allocations;
  step(*world);
  const std::int64_t count = allocations - before;
  ASSERT_GT(count, 20);
  // A world takes longer to make than to step: of many allocations a part fails, from all over the step.
  constexpr std::int64_t kMostTries = 150;
  const std::int64_t stride = std::max<std::int64_t>(1, count / kMostTries);
  int failures = 0, tries = 0;
  for (std::int64_t n = 0; n < count; n += stride) {
    ++tries;
    world = make();
    allocations_left = n;
    try {
      step(*world);
    } catch (const std::bad_alloc&) {
      ++failures;
    }
    allocations_left = kNever;
  }
  EXPECT_GT(failures, tries / 4);
  world.reset();
  fs::remove_all(folder);
}

}  // namespace
}  // namespace soarbox::sim
