// SPDX-License-Identifier: BSD-2-Clause
// Minds that grow without a limit are halted before they use up all memory; the world and the other minds continue.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "sim/simulation.h"

namespace soarbox::sim {
namespace {

namespace fs = std::filesystem;

/// Adds 225 elements in each tick: one for each pair of 15 things.
constexpr const char* kHog = R"(
sp {hog*remember (state <s> ^superstate nil ^io.input-link.time <t>) --> (<s> ^operator <o> + =) (<o> ^name grow ^at <t>)}
sp {hog*things (state <s> ^superstate nil) --> (<s> ^thing 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)}
sp {hog*grow (state <s> ^operator <o> ^thing <a> ^thing <b>) (<o> ^name grow ^at <t>)
   --> (<s> ^kept <k>) (<k> ^first <a> ^second <b> ^at <t>)}
)";
constexpr const char* kHonest = R"(
sp {honest*say (state <s> ^superstate nil ^io <io>) (<io> ^input-link.time <t> ^output-link <out>)
   --> (<s> ^operator <o> + =) (<o> ^name turn-by ^at <t>)}
sp {honest*turn (state <s> ^operator.name turn-by ^io.output-link <out>) --> (<out> ^turn-by <w>) (<w> ^angle 1)}
)";

struct Outcome {
  std::set<std::string> halted;
  std::string first;
  std::uint64_t hash = 0;
};

Outcome PlayHogs(int hogs, std::size_t limit_bytes, int threads, int ticks) {
  const fs::path folder = fs::path(testing::TempDir()) / ("hogs-" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "hog.soar") << kHog;
  std::ofstream(folder / "honest.soar") << kHonest;
  std::ofstream(folder / "scenario.toml")
      << "description = \"hogs\"\nseconds = 60\n"
      << "[[agent]]\nname = \"honest\"\nrules = \"honest.soar\"\n"
      << "[[agent]]\nname = \"hog\"\nrules = \"hog.soar\"\ncount = " << hogs << "\nposition = [5, 5]\n";
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = FindScenario(folder.string(), {root + "/scenarios", root + "/media"});
  EXPECT_TRUE(scenario.ok());
  SimulationSettings settings;
  settings.soar.threads = threads;
  settings.limits.memory_bytes = limit_bytes;
  auto simulation = Simulation::Create(scenario.value(), settings);
  EXPECT_TRUE(simulation.ok());
  Outcome outcome;
  for (int i = 0; i < ticks; ++i) {
    (*simulation)->Tick();
    for (const RunEvent& event : (*simulation)->TakeEvents()) {
      if (event.kind != EventKind::kMindFailed) continue;
      if (outcome.halted.empty()) outcome.first = event.diagnostic.message;
      outcome.halted.insert(event.agent);
    }
  }
  EXPECT_EQ((*simulation)->tick(), static_cast<std::uint64_t>(ticks));
  for (const std::string& agent : outcome.halted) EXPECT_TRUE((*simulation)->Why(agent).has_value());
  outcome.hash = (*simulation)->StateHash();
  fs::remove_all(folder);
  return outcome;
}

/// In such builds the kernel checks all matches after each phase. Growing minds then take minutes, and use other
/// amounts of memory than in builds for users.
#ifdef SOARBOX_CHECK_INVARIANTS
constexpr bool kChecksInvariants = true;
#else
constexpr bool kChecksInvariants = false;
#endif

TEST(MindMemory, AHundredMindsThatGrowAreHaltedOneByOneAndTheWorldGoesOn) {
  if (kChecksInvariants) GTEST_SKIP() << "the kernel checks itself";
  const Outcome outcome = PlayHogs(100, std::size_t{30} << 20, 1, 10);
  EXPECT_FALSE(outcome.halted.empty());
  EXPECT_FALSE(outcome.halted.contains("honest"));
  EXPECT_NE(outcome.first.find("this world needs more than 30 MB of memory"), std::string::npos) << outcome.first;
}

TEST(MindMemory, WhoIsHaltedDoesNotDependOnTheThreads) {
  if (kChecksInvariants) GTEST_SKIP() << "the kernel checks itself";
  const Outcome one = PlayHogs(8, std::size_t{3} << 20, 1, 12), two = PlayHogs(8, std::size_t{3} << 20, 2, 12);
  EXPECT_FALSE(one.halted.empty());
  EXPECT_EQ(one.halted, two.halted);
  EXPECT_EQ(one.hash, two.hash);
}

TEST(MindMemory, NobodyIsHaltedWhileThereIsRoom) {
  EXPECT_TRUE(PlayHogs(3, std::size_t{1} << 30, 1, 5).halted.empty());
}

/// Learns a rule for each number that it counts, and another for each tick.
constexpr const char* kCounter = R"(
sp {count*init (state <s> ^superstate nil) --> (<s> ^turn 1)}
sp {count*propose*look (state <s> ^superstate nil ^turn <n> -^seen <n>) --> (<s> ^operator <o> +) (<o> ^name look)}
sp {count*look (state <ss> ^superstate <s>) (<s> ^operator.name look ^turn { <n> > 0 }) --> (<ss> ^at (+ <n> 0))}
sp {count*note (state <ss> ^superstate <s> ^at <n>) --> (<s> ^seen <n>)}
sp {count*propose*next (state <s> ^superstate nil ^turn <n> ^seen <n>) --> (<s> ^operator <o> +) (<o> ^name next ^turn <n>)}
sp {count*next (state <s> ^operator <o>) (<o> ^name next ^turn <n>) --> (<s> ^turn <n> - (+ <n> 1))}
)";

TEST(MindMemory, AMindThatLearnsTooMuchIsToldOfOnceWithTheRuleThatIsToBlame) {
  const fs::path folder = fs::path(testing::TempDir()) / ("learner-" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "counter.soar") << "chunk always\n" << kCounter;
  std::ofstream(folder / "scenario.toml") << "description = \"counts\"\nseconds = 600\n"
                                          << "[[agent]]\nname = \"counter\"\nrules = \"counter.soar\"\n";
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = FindScenario(folder.string(), {root + "/scenarios", root + "/media"});
  ASSERT_TRUE(scenario.ok());
  auto simulation = Simulation::Create(scenario.value(), {});
  ASSERT_TRUE(simulation.ok());
  std::vector<std::string> told;
  std::uint64_t first = 0;
  for (int i = 0; i < 3000 && (told.empty() || i < 1200); ++i) {
    (*simulation)->Tick();
    for (const RunEvent& event : (*simulation)->TakeEvents()) {
      if (event.kind != EventKind::kDiagnostic || event.diagnostic.message.find("has learned") == std::string::npos)
        continue;
      told.push_back(event.diagnostic.message);
      if (first == 0) first = (*simulation)->tick();
    }
  }
  fs::remove_all(folder);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_GT(first, 0u);
  EXPECT_NE(told.front().find("the mind of counter has learned 5"), std::string::npos) << told.front();
  EXPECT_NE(told.front().find("of them from 'count*note'"), std::string::npos) << told.front();
}

}  // namespace
}  // namespace soarbox::sim
