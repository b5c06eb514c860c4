// SPDX-License-Identifier: BSD-2-Clause
// Minds decide on several threads; the run does not depend on their number.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/without_threads.h"
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

TEST(WorkerPool, WhereNoThreadCanBeStartedTheOwnerDoesAllJobs) {
  const WithoutThreads none;
  WorkerPool pool(3);
  std::vector<int> calls(3);
  for (int round = 0; round < 10; ++round) pool.Run([&](std::size_t number) { ++calls[number]; });
  const std::function<void(std::size_t)> job = [&](std::size_t number) { ++calls[number]; };
  pool.Begin(job);
  EXPECT_EQ(calls, (std::vector<int>{10, 11, 11}));
  pool.Join();
}

TEST(WorkerPool, ThoseWhoLookAroundInOneTickAreSpreadOverAllThreads) {
  for (std::size_t threads = 1; threads <= 16; ++threads) {
    // Minds with numbers n, n + 3, n + 6, ... look around in the same tick. Each thread must get one of each third.
    std::vector<std::vector<int>> of_third(threads, std::vector<int>(3));
    for (std::uint64_t number = 0; number < 3 * threads; ++number) ++of_third[ThreadOf(number, threads)][number % 3];
    EXPECT_EQ(of_third, std::vector(threads, std::vector<int>(3, 1))) << threads;
  }
}

/// The state hash of each tick.
std::vector<std::uint64_t> Play(const char* name, int threads, std::uint64_t seed, int ticks) {
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = FindScenario(name, {root + "/scenarios", root + "/media"});
  EXPECT_TRUE(scenario.ok());
  SimulationSettings settings;
  settings.seed = seed;
  settings.soar.threads = threads;
  auto simulation = Simulation::Create(scenario.value(), settings);
  EXPECT_TRUE(simulation.ok());
  // Minds without rules would also be the same on any number of threads.
  for (const RunEvent& event : (*simulation)->TakeEvents())
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
  // One crowd has as many minds as threads; the other has more, but runs for fewer ticks. With sanitizers and checked
  // invariants, a decision costs a hundred times as much as for users.
  const std::pair<const char*, int> runs[] = {{"crowd/crowd_10.lua", 60}, {"crowd/crowd_100.lua", 8}, {"thesis", 30}};
  for (const auto& [name, ticks] : runs) {
    const auto one = Play(name, 1, 7, ticks);
    EXPECT_EQ(Play(name, 2, 7, ticks), one) << name;
    EXPECT_EQ(Play(name, 3, 7, ticks), one) << name;
    // Checks that a different seed gives different hashes.
    EXPECT_NE(Play(name, 2, 8, ticks), one) << name;
  }
}

/// A crowd that wanders, and one agent in it that first does something else. All agents after it then compute their
/// directions in their own turn.
std::vector<std::uint64_t> Stroll(int threads) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("soarbox_stroll_" + std::to_string(threads));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const char* text) { std::ofstream(folder / name) << text; };
  write("scenario.toml", R"(
[[agent]]
name = "early"
rules = "stroll.soar"
count = 20
across = 5
[[agent]]
name = "waiter"
rules = "wait.soar"
position = [10, 0]
[[agent]]
name = "late"
rules = "stroll.soar"
count = 20
across = 5
position = [0.7, 0.7]
)");
  write("stroll.soar", R"(
sp {propose*wander (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name wander)}
sp {apply*wander (state <s> ^operator.name wander ^io.output-link <out>) --> (<out> ^wander <c>)}
)");
  write("wait.soar", R"(
sp {propose*wait (state <s> ^superstate nil ^io.input-link.self) --> (<s> ^operator <o> +) (<o> ^name wait)}
sp {apply*wait (state <s> ^operator.name wait ^io.output-link <out>) --> (<out> ^wait <c>) (<c> ^seconds 0.3)}
)");
  auto hashes = Play((folder / "scenario.toml").c_str(), threads, 7, 24);
  std::filesystem::remove_all(folder);
  return hashes;
}

TEST(Threads, WaysThroughACrowdAreTheSameOnAnyNumberOfThem) {
  const auto one = Stroll(1);
  EXPECT_NE(one.front(), one.back());
  EXPECT_EQ(Stroll(2), one);
  EXPECT_EQ(Stroll(5), one);
}

/// The events of a world. Its scripts create agents with minds while others decide; minds are idle, halt and write.
std::string Happenings(int threads) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("soarbox_beside_" + std::to_string(threads));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const char* text) { std::ofstream(folder / name) << text; };
  write("Sandbox.lua", R"(
function Sandbox_Initialize(sandbox)
  for i = 1, 12 do Sandbox.CreateSoarAgent(sandbox, "Body.lua", i % 4 == 0 and "gap.soar" or "count.soar") end
end
)");
  write("Body.lua", R"(
function Agent_Initialize(agent) agent:SetPosition(Vector.new(agent:GetId() * 2, 0.8, 0)) end
function Agent_Sense(agent) return { number = agent:GetId() } end
function Agent_Update(agent, millis, command, parameters)
  agent:SetHealth(agent:GetHealth() - parameters.step)
  local sandbox = agent:GetSandbox()
  if (agent:GetId() % 3 == 1 and #Sandbox.GetAgents(sandbox) < 20 and agent:GetHealth() < 95) then
    Sandbox.CreateSoarAgent(sandbox, "Body.lua", "count.soar")
  end
  if (agent:GetHealth() < 80) then error("too weak: " .. agent:GetId()) end
end
)");
  write("count.soar", R"(
sp {propose*step (state <s> ^superstate nil ^io.output-link <o>) -(<o> ^step) --> (<s> ^operator <p> +) (<p> ^name step)}
sp {apply*step (state <s> ^operator.name step ^io <io>) (<io> ^output-link <o> ^input-link.number <n>)
  --> (<o> ^step <c>) (<c> ^step <n>) (write (crlf) |step of | <n>)}
sp {propose*clear (state <s> ^superstate nil ^io.output-link.step.status) --> (<s> ^operator <p> +) (<p> ^name clear)}
sp {apply*clear (state <s> ^operator.name clear ^io.output-link <o>) (<o> ^step <c>) --> (<o> ^step <c> -)}
)");
  write("gap.soar", "sp {nothing (state <s> ^io.output-link.never <x>) --> (<s> ^never <x>)}");
  const auto found = FindScenario(folder.string(), {SOARBOX_SOURCE_DIR "/scenarios", SOARBOX_SOURCE_DIR "/media"});
  EXPECT_TRUE(found.ok());
  SimulationSettings settings;
  settings.soar.threads = threads;
  settings.every_command = true;
  auto simulation = Simulation::Create(found.value(), settings);
  EXPECT_TRUE(simulation.ok());
  std::string told;
  for (int tick = 0; tick < 20; ++tick) {
    (*simulation)->Tick();
    for (const RunEvent& event : (*simulation)->TakeEvents())
      told += std::to_string(event.tick) + " " + event.agent + " " + event.text + event.diagnostic.message + "\n";
    told += std::to_string((*simulation)->StateHash()) + "\n";
  }
  (*simulation)->Finish();
  std::filesystem::remove_all(folder);
  return told;
}

TEST(Threads, MindsThatAreMadeOrAskedWhileOthersDecideChangeNothing) {
  const std::string one = Happenings(1);
  for (const char* part : {"step of 7", "agent-20", "gave no command", "too weak"})
    EXPECT_NE(one.find(part), std::string::npos) << part << " in\n" << one;
  EXPECT_EQ(Happenings(2), one);
  EXPECT_EQ(Happenings(4), one);
}

}  // namespace
}  // namespace soarbox::sim
