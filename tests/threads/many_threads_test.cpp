// SPDX-License-Identifier: BSD-2-Clause
// Agents share nothing that changes: their transcripts must be identical if each runs alone, all take turns on one
// thread, or many threads run them. Agents with equal rules share these, so each script runs several times at once;
// some agents change their rules while others that share them run.
#include <gtest/gtest.h>

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "agent_scripts.h"
#include "script_runner.h"

namespace {

using Runners = std::vector<std::unique_ptr<ScriptRunner>>;

constexpr int kCopies = 3;
#if defined(SOARBOX_CHECK_INVARIANTS) || defined(__SANITIZE_THREAD__)
constexpr int kSlowness = 10;  // Sanitizers.
#else
constexpr int kSlowness = 1;
#endif

std::vector<std::string> RunEachAlone(const std::vector<AgentScript>& scripts) {
  std::vector<std::string> transcripts;
  for (const AgentScript& script : scripts) {
    ScriptRunner runner(script);
    while (runner.Step()) {
    }
    transcripts.push_back(runner.transcript());
  }
  return transcripts;
}

Runners MakeRunners(const std::vector<AgentScript>& scripts) {
  Runners runners;
  for (int copy = 0; copy < kCopies; ++copy) {
    for (const AgentScript& script : scripts) runners.push_back(std::make_unique<ScriptRunner>(script));
  }
  return runners;
}

void RunInTurns(Runners& runners) {
  std::deque<ScriptRunner*> queue;
  for (const auto& runner : runners) queue.push_back(runner.get());
  while (!queue.empty()) {
    ScriptRunner* runner = queue.front();
    queue.pop_front();
    if (runner->Step()) queue.push_back(runner);
  }
}

/// Each thread takes the agent that has waited longest and executes one line of it, so that agents move between
/// threads.
void RunOnThreads(Runners& runners, int thread_count) {
  std::mutex mutex;
  std::deque<ScriptRunner*> queue;
  for (const auto& runner : runners) queue.push_back(runner.get());
  std::vector<std::thread> threads;
  for (int n = 0; n < thread_count; ++n) {
    threads.emplace_back([&] {
      while (true) {
        ScriptRunner* runner = nullptr;
        {
          const std::lock_guard<std::mutex> lock(mutex);
          // Another thread may still return its agent, and then continues with it.
          if (queue.empty()) return;
          runner = queue.front();
          queue.pop_front();
        }
        if (!runner->Step()) continue;
        const std::lock_guard<std::mutex> lock(mutex);
        queue.push_back(runner);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

/// The thread that takes an agent creates, runs and destroys it, so that agents that share rules come and go.
void RunWholeOnThreads(const std::vector<AgentScript>& scripts, const std::vector<std::string>& wanted,
                       int thread_count) {
  std::vector<std::thread> threads;
  for (int n = 0; n < thread_count; ++n) {
    threads.emplace_back([&, n] {
      for (std::size_t i = 0; i < scripts.size(); ++i) {
        const std::size_t which = n % 2 == 0 ? i : scripts.size() - 1 - i;
        ScriptRunner runner(scripts[which]);
        while (runner.Step()) {
        }
        EXPECT_EQ(runner.transcript(), wanted[which]) << scripts[which].name << " on thread " << n;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

void ExpectSame(const Runners& runners, const std::vector<AgentScript>& scripts,
                const std::vector<std::string>& wanted) {
  for (std::size_t i = 0; i < runners.size(); ++i) {
    const std::size_t script = i % scripts.size();
    ASSERT_EQ(runners[i]->transcript(), wanted[script]) << scripts[script].name;
  }
}

void ExpectTheSameHoweverTheyRun(const std::vector<AgentScript>& scripts, int repetitions) {
  const std::vector<std::string> wanted = RunEachAlone(scripts);
  for (std::size_t i = 0; i < scripts.size(); ++i) ASSERT_GT(wanted[i].size(), 200u) << scripts[i].name;
  {
    Runners runners = MakeRunners(scripts);
    RunInTurns(runners);
    ExpectSame(runners, scripts, wanted);
  }
  for (int repetition = 0; repetition * kSlowness < repetitions && !testing::Test::HasFailure(); ++repetition) {
    for (const int thread_count : {2, 4, 8}) {
      Runners runners = MakeRunners(scripts);
      RunOnThreads(runners, thread_count);
      ExpectSame(runners, scripts, wanted);
    }
    RunWholeOnThreads(scripts, wanted, 4);
  }
}

TEST(ManyThreads, OurAgentsRunAsTheyDoAlone) {
  ExpectTheSameHoweverTheyRun(LocalScripts(), 10);
}

TEST(ManyThreads, TheGoldenCasesRunAsTheyDoAlone) {
  const std::vector<AgentScript> scripts = GoldenScripts(SOARBOX_SOURCE_DIR "/tests/golden/core");
  ASSERT_FALSE(scripts.empty());
  ExpectTheSameHoweverTheyRun(scripts, 3);
}

TEST(ManyThreads, TheBenchmarkAgentsRunAsTheyDoAlone) {
  const std::vector<AgentScript> scripts = BenchmarkScripts(SOARBOX_SOURCE_DIR "/bench/agents", 100 / kSlowness);
  ASSERT_FALSE(scripts.empty());
  ExpectTheSameHoweverTheyRun(scripts, 1);
}

}  // namespace
