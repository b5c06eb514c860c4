// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "cli/interpreter.h"
#include "cli/session.h"
#include "kernel/agent.h"
#include "kernel/longterm/episodic_memory.h"
#include "kernel/longterm/long_term.h"

namespace soarbox::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// An agent with a counter on its top state and a command line, in a folder.
struct Counter {
  explicit Counter(const fs::path& folder, const std::string& settings = {}) {
    Do("cd " + folder.string());
    Do(settings);
    Do("sp {begin (state <s> ^superstate nil -^n) --> (<s> ^operator <o> +) (<o> ^name begin)}");
    Do("sp {begin*apply (state <s> ^operator.name begin) --> (<s> ^n 1)}");
    Do("sp {count (state <s> ^superstate nil ^n <n>) --> (<s> ^operator <o> +) (<o> ^name count ^n <n>)}");
    Do("sp {count*apply (state <s> ^operator <o> ^n <n>) (<o> ^name count ^n <n>) --> (<s> ^n <n> - (+ <n> 1))}");
  }
  std::string Do(const std::string& line) { return interpreter.Execute(session, line).text; }
  kernel::EpisodicMemory& memory() { return kernel::EpisodicMemory::Of(agent.long_term()); }

  kernel::Agent agent{"soar"};
  Session session{agent};
  Interpreter interpreter;
};

constexpr const char* kEpisodeFile =
    "epmem --set path episodes.db; epmem --set database file; epmem --set append on; epmem --enable";

class EpisodicFiles : public testing::Test {
 protected:
  EpisodicFiles() {
    folder_ = fs::temp_directory_path() /
              ("soarbox_epmem_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    folder_ = fs::canonical(folder_);
  }
  ~EpisodicFiles() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(EpisodicFiles, GoOnWhereTheyEnded) {
  std::string third, graph;
  {
    Counter first(folder_, kEpisodeFile);
    first.Do("run 5");
    third = first.Do("epmem --print 3");
    graph = first.Do("epmem --viz 3");
    EXPECT_THAT(third, HasSubstr("^n 3"));
    EXPECT_THAT(first.Do("epmem --backup copy.db"), HasSubstr("backed up"));
  }
  for (const char* file : {"episodes.db", "copy.db"}) {
    Counter second(folder_, std::string(kEpisodeFile) + "; epmem --set path " + file);
    EXPECT_EQ(second.Do("epmem --print 3"), third) << file;
    EXPECT_EQ(second.Do("epmem --viz 3"), graph);
    EXPECT_STREQ(second.memory().store().CheckInvariants(), "");
    const auto before = second.memory().store().last();
    second.Do("run 3");
    EXPECT_GE(second.memory().store().last(), before + 2);
    EXPECT_EQ(second.Do("epmem --print 3"), third);
    EXPECT_STREQ(second.memory().store().CheckInvariants(), "");
    // A query finds values that only the earlier run contained.
    second.Do("sp {ask (state <s> ^superstate nil ^epmem.command <c>) --> (<c> ^query.n 4 ^before " +
              std::to_string(before + 1) + ")}");
    second.Do("run 1");
    EXPECT_GT(second.memory().counters().query_retrieved, 0u);
    EXPECT_LE(second.memory().counters().query_retrieved, before);
  }
}

TEST_F(EpisodicFiles, AreEmptiedUnlessTheyAreAppendedTo) {
  { Counter(folder_, kEpisodeFile).Do("run 5"); }
  Counter second(folder_, std::string(kEpisodeFile) + "; epmem --set append off");
  second.Do("run 2");
  EXPECT_LE(second.memory().store().last(), 2u);
  // init-soar also starts again, or continues.
  second.Do("init-soar; run 2");
  EXPECT_LE(second.memory().store().last(), 2u);
  second.Do("epmem --set append on");
  const auto before = second.memory().store().last();
  second.Do("init-soar; run 2");
  const auto after = second.memory().store().last();
  EXPECT_GT(after, before);
  EXPECT_THAT(second.Do("epmem --close"), HasSubstr("closed"));
  EXPECT_EQ(second.memory().store().last(), 0u);
  second.Do("run 1");
  EXPECT_GT(second.memory().store().last(), after);
}

TEST_F(EpisodicFiles, ThatCannotBeUsedAreNamedAndStay) {
  std::ofstream(folder_ / "episodes.db") << std::string(300, 'x');
  {
    Counter counter(folder_, kEpisodeFile);
    EXPECT_THAT(counter.Do("epmem --init"), HasSubstr("episodes.db is not a database"));
    EXPECT_EQ(fs::file_size(folder_ / "episodes.db"), 300u);
    // A run continues without the memory.
    counter.Do("run 3");
    EXPECT_GT(counter.memory().store().last(), 1u);
    EXPECT_EQ(fs::file_size(folder_ / "episodes.db"), 300u);
  }
  fs::remove(folder_ / "episodes.db");
  Counter first(folder_, kEpisodeFile), second(folder_, kEpisodeFile);
  first.Do("run 2");
  EXPECT_THAT(second.Do("epmem --print 1"), HasSubstr("in use by another process"));
  // Semantic memory is stored elsewhere.
  first.Do("epmem --close");
  EXPECT_THAT(second.Do("smem --set path episodes.db; smem --set database file; smem --add {(@1 ^a b)}"),
              HasSubstr("another kind"));
}

TEST_F(EpisodicFiles, AKilledAgentLosesTheDecisionUnderWayAtMost) {
  std::uint64_t kept = 0;
  for (int round = 0; round < 8; ++round) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      Counter counter(folder_, kEpisodeFile);
      for (;;) {
        counter.agent.Step(kernel::RunUnit::kDecision);
        const std::uint64_t last = counter.memory().store().last();
        if (write(ends[1], &last, sizeof last) != sizeof last) _exit(0);
      }
    }
    close(ends[1]);
    std::uint64_t last = 0, number = 0;
    for (int n = 0; n < 4 + round && read(ends[0], &number, sizeof number) == sizeof number; ++n) last = number;
    kill(child, SIGKILL);
    while (read(ends[0], &number, sizeof number) == sizeof number) last = number;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    Counter counter(folder_, kEpisodeFile);
    counter.Do("epmem --print 1");
    const std::uint64_t now = counter.memory().store().last();
    EXPECT_STREQ(counter.memory().store().CheckInvariants(), "");
    EXPECT_GE(now, last);
    EXPECT_LE(now, last + 1);
    EXPECT_GT(now, kept);
    kept = now;
  }
}

}  // namespace
}  // namespace soarbox::cli
