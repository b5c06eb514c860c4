// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/semantic_memory.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "cli/interpreter.h"
#include "cli/session.h"
#include "kernel/agent.h"
#include "kernel/longterm/long_term.h"

namespace soarbox::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// An agent with a command line, in a folder.
struct Desk {
  explicit Desk(const fs::path& folder) { Do("cd " + folder.string()); }
  std::string Do(const std::string& line) { return interpreter.Execute(session, line).text; }

  kernel::Agent agent{"soar"};
  Session session{agent};
  Interpreter interpreter;
};

std::string Text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class SemanticMemoryTest : public testing::Test {
 protected:
  SemanticMemoryTest() {
    folder_ = fs::temp_directory_path() /
              ("soarbox_smem_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    folder_ = fs::canonical(folder_);
  }
  ~SemanticMemoryTest() override { fs::remove_all(folder_); }

  static constexpr const char* kFile = "smem --set path facts.db; smem --set database file; smem --enable";
  /// Counts up, and stores each number in a separate object.
  static constexpr const char* kCounting =
      "sp {start (state <s> ^superstate nil -^n) --> (<s> ^operator <o> +) (<o> ^name start)}\n"
      "sp {start*apply (state <s> ^operator.name start) --> (<s> ^n 1)}\n"
      "sp {count (state <s> ^superstate nil ^n <n>) --> (<s> ^operator <o> + =) (<o> ^name count ^n <n>)}\n"
      "sp {count*apply (state <s> ^operator <o> ^n <n> ^smem.command <c>) (<o> ^name count ^n <n>) -->"
      " (<s> ^n <n> - ^n (+ <n> 1)) (<c> ^store <x>) (<x> ^number <n>)}\n"
      "sp {forget (state <s> ^operator <o> ^smem (^command <c> ^result.success <x>)) (<o> ^name count)"
      " (<c> ^store <x>) --> (<c> ^store <x> -)}\n";
  fs::path folder_;
};

TEST_F(SemanticMemoryTest, SavingTheAgentKeepsFactsAndSettings) {
  Desk desk(folder_);
  desk.Do("smem --enable");
  desk.Do("smem --set activation-mode frequency");
  desk.Do("smem --add {(@1 ^name alpha ^next @2 ^age 3) (@2 ^name beta)}");
  const std::string before = desk.Do("print @");
  EXPECT_THAT(before, HasSubstr("^name alpha"));
  desk.Do("save agent agent.soar");
  Desk other(folder_);
  other.Do("source agent.soar");
  EXPECT_EQ(other.Do("print @"), before);
  EXPECT_EQ(other.Do("smem --get activation-mode"), desk.Do("smem --get activation-mode"));
}

TEST_F(SemanticMemoryTest, WhatMakesNoSenseIsRefused) {
  Desk desk(folder_);
  desk.Do("smem --enable");
  desk.Do("smem --add {(@1 ^name alpha)}");
  EXPECT_THAT(desk.Do("smem --set initial-variable-id 0"), HasSubstr("The id counter must be at least 1."));
  EXPECT_THAT(desk.Do("smem --timers nothing"), HasSubstr("Invalid timer."));
  EXPECT_THAT(desk.Do("smem --precalculate"), HasSubstr("Unknown option."));
  EXPECT_THAT(desk.Do("smem --query {(<q> ^name @0)}"), HasSubstr("LTI was not found."));
  EXPECT_THAT(desk.Do("smem --remove {(@0)}"), HasSubstr("No LTI found for that id."));
  EXPECT_THAT(desk.Do("smem --history @0"), HasSubstr("LTI not found."));
  // Without bars it is an identifier, which cannot be an attribute.
  EXPECT_THAT(desk.Do("smem --add {(@1 ^k4 2)}"), HasSubstr("Error parsing clause #0"));
  EXPECT_THAT(desk.Do("smem --query {(<q> ^k4 2)}"), HasSubstr("Error parsing clause #1."));
  EXPECT_EQ(desk.Do("smem --stats edges"), " 1\n");
  // As in Soar, spreading requires base-level activation.
  EXPECT_THAT(desk.Do("smem --set spreading on"), HasSubstr("cannot be turned on"));
  desk.Do("smem --set activation-mode base-level; smem --set spreading on");
  EXPECT_THAT(desk.Do("smem --set activation-mode word"), HasSubstr("Invalid setting"));
  EXPECT_THAT(desk.Do("smem --set activation-mode recency"), HasSubstr("cannot be changed while spreading"));
  EXPECT_EQ(desk.Do("smem --get activation-mode"), "activation-mode is base-level\n");
  desk.Do("smem --set spreading off");
  EXPECT_EQ(desk.Do("smem --set activation-mode recency"), "activation-mode is now recency\n");
}

TEST_F(SemanticMemoryTest, AFileHoldsFactsAndHowActiveTheyAre) {
  std::string before;
  {
    Desk desk(folder_);
    desk.Do(kFile);
    desk.Do("smem --add {(@1 ^kind k ^n 1.5 ^next @2) (@2 ^kind k ^name |a b|) (@steel ^kind k)}");
    desk.Do("sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind k)}");
    desk.Do("run 3");
    before = desk.Do("print @");
    EXPECT_THAT(before, HasSubstr("[+1.000]"));
    EXPECT_THAT(desk.Do("smem --backup copy.db"), HasSubstr("backed up"));
  }
  for (const char* file : {"facts.db", "copy.db"}) {
    Desk desk(folder_);
    desk.Do("smem --set path " + std::string(file) + "; smem --set database file");
    desk.Do("smem --init");
    EXPECT_EQ(desk.Do("print @"), before) << file;
    EXPECT_EQ(desk.Do("print @steel"), "(@steel ^kind k [+1.000])\n");
    desk.Do("smem --remove {(@steel ^kind)}");
    desk.Do("smem --clear; smem --add {(@7 ^a b)}");
  }
  Desk desk(folder_);
  desk.Do(kFile);
  EXPECT_EQ(desk.Do("print @"), "(@7 ^a b [+0.000])\n");
}

TEST_F(SemanticMemoryTest, AFileHoldsTheWeightsOfLinks) {
  constexpr const char* kMode = "smem --set activation-mode base-level; smem --set spreading on";
  // Both objects get the activation from @1; of equal ones the younger would be first.
  constexpr const char* kAsk =
      "sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.name hub)}\n"
      "sp {keep (state <s> ^smem.result.retrieved <r>) --> (<s> ^kept <r>)}\n"
      "sp {wait (state <s> ^superstate nil) --> (<s> ^operator.name wait)}";
  const auto order = [&](Desk& desk) {
    desk.Do(kAsk);
    desk.Do("run 2");
    const std::string found = desk.Do("smem --query {(<q> ^n <any>)} 2");
    return found.substr(0, 3) + found.substr(found.find('\n') + 1, 3);
  };
  {
    Desk equal(folder_);
    equal.Do(kMode);
    equal.Do("smem --enable; smem --add {(@1 ^name hub ^a @2 ^b @3) (@2 ^n 2) (@3 ^n 3)}");
    EXPECT_EQ(order(equal), "(@3(@2");
    Desk desk(folder_);
    desk.Do(kFile);
    desk.Do("smem --add {(@1 ^name hub ^a @2 (0.9) ^b @3 (0.1)) (@2 ^n 2) (@3 ^n 3)}");
    desk.Do("smem --backup copy.db");
  }
  for (const char* file : {"facts.db", "copy.db"}) {
    Desk desk(folder_);
    desk.Do(kMode);
    desk.Do("smem --set path " + std::string(file) + "; smem --set database file; smem --enable");
    EXPECT_EQ(order(desk), "(@2(@3") << file;
  }
}

TEST_F(SemanticMemoryTest, FilesThatCannotBeUsedAreNamedAndStay) {
  std::ofstream(folder_ / "facts.db") << "no database at all, and longer than a header of a hundred bytes would be: "
                                         "so there is no doubt about what it is";
  const auto size = fs::file_size(folder_ / "facts.db");
  {
    Desk desk(folder_);
    desk.Do(kFile);
    EXPECT_THAT(desk.Do("smem --add {(@1 ^a b)}"), HasSubstr("facts.db is not a database"));
    EXPECT_EQ(fs::file_size(folder_ / "facts.db"), size);
    EXPECT_THAT(desk.Do("smem --init"), HasSubstr("facts.db is not a database"));
    EXPECT_THAT(desk.Do("smem --backup facts.db; smem --set database memory; smem --backup facts.db"),
                HasSubstr("facts.db is not a database"));
  }
  Desk first(folder_), second(folder_);
  for (Desk* desk : {&first, &second}) desk->Do("smem --set path other.db; smem --set database file");
  EXPECT_THAT(first.Do("smem --add {(@1 ^a b)}"), HasSubstr("Knowledge added"));
  EXPECT_THAT(second.Do("smem --add {(@2 ^a b)}"), HasSubstr("in use by another process"));
  // A run continues without the memory.
  second.Do("smem --enable");
  second.Do("smem --set path nowhere/at/all.db");
  EXPECT_THAT(second.Do("smem --init"), HasSubstr("cannot be opened"));
}

TEST_F(SemanticMemoryTest, AKilledAgentLosesTheDecisionUnderWayAtMost) {
  int stored = 0;
  for (int round = 0; round < 12; ++round) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      Desk desk(folder_);
      desk.Do(kFile);
      desk.Do(kCounting);
      desk.Do("smem --init");
      // Number of stores whose output phase has ended, after each decision.
      for (;;) {
        desk.agent.Step(kernel::RunUnit::kDecision);
        const std::uint64_t done = kernel::SemanticMemory::Of(desk.agent.long_term()).counters().stores;
        if (write(ends[1], &done, sizeof(done)) != sizeof(done)) _exit(0);
      }
    }
    close(ends[1]);
    std::uint64_t done = 0, number = 0;
    for (int n = 0; n < 5 + round && read(ends[0], &number, sizeof(number)) == sizeof(number); ++n) done = number;
    kill(child, SIGKILL);
    while (read(ends[0], &number, sizeof(number)) == sizeof(number)) done = number;
    close(ends[0]);
    waitpid(child, nullptr, 0);

    Desk desk(folder_);
    desk.Do(kFile);
    desk.Do("smem --init");
    const kernel::Knowledge& knowledge = kernel::SemanticMemory::Of(desk.agent.long_term()).knowledge();
    EXPECT_EQ(knowledge.CheckInvariants(), "");
    const int now = static_cast<int>(knowledge.object_count());
    EXPECT_GE(now, stored + static_cast<int>(done));
    EXPECT_LE(now, stored + static_cast<int>(done) + 1);
    EXPECT_EQ(knowledge.edge_count(), knowledge.object_count());
    stored = now;
  }
  EXPECT_GT(stored, 12);
}

TEST_F(SemanticMemoryTest, WhatItAnswersKeepsTheKernelsInvariants) {
  Desk desk(folder_);
  desk.Do("smem --enable; wm activation --set forgetting on; wm activation --set activation on");
  desk.Do("smem --add {(@1 ^kind k ^n 1 ^next @2) (@2 ^kind k ^n 2 ^next @1 ^deep.er 3)}");
  desk.Do("sp {any (state <s> ^smem.command <c> ^type state -^kept) --> (<c> ^query.kind k ^depth 3)}");
  desk.Do("sp {result (state <s> ^superstate <ss> ^smem.result.retrieved <r>) --> (<ss> ^got <r>)}");
  desk.Do(
      "sp {keep (state <s> ^superstate <ss> ^smem.result.retrieved <r>) --> (<s> ^operator <o> + =)"
      " (<o> ^name keep ^r <r>)}");
  desk.Do(
      "sp {keep*apply (state <s> ^operator <o>) (<o> ^name keep ^r <r>) -->"
      " (<s> ^kept <r>)}");
  // Not together with the query, which is removed when this is added: two kinds of commands at once are invalid.
  desk.Do("sp {put (state <s> ^kept <r> ^smem.command <c>) --> (<c> ^store <r>)}");
  for (int n = 0; n < 40; ++n) {
    desk.agent.Step(kernel::RunUnit::kPhase);
    ASSERT_EQ(desk.agent.CheckInvariants(), "") << "after phase " << n;
  }
  EXPECT_THAT(desk.Do("smem --stats stores"), testing::Not(HasSubstr(" 0\n")));
  desk.Do("init-soar");
  EXPECT_EQ(desk.agent.CheckInvariants(), "");
  desk.Do("run 5");
  EXPECT_EQ(desk.agent.CheckInvariants(), "");
}

TEST_F(SemanticMemoryTest, AgentsThatKnowTheSameShareIt) {
  std::string facts;
  for (int n = 1; n <= 200; ++n) facts += "(@" + std::to_string(n) + " ^kind k ^n " + std::to_string(n) + ")";
  Desk first(folder_), second(folder_), third(folder_);
  for (Desk* desk : {&first, &second, &third}) {
    desk->Do("smem --enable; smem --add {" + facts + "}");
    desk->Do("sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind k)}");
  }
  third.Do("smem --add {(@7 ^more x)}");
  // One value differs, or only a removed value, which affects the order in which values are shown.
  Desk fourth(folder_), fifth(folder_);
  std::string others = facts;
  others.replace(others.find("^n 100)"), 7, "^n 999)");
  fourth.Do("smem --enable; smem --add {" + others + "}");
  fifth.Do("smem --enable; smem --add {" + facts + "}; smem --add {(@1 ^z y)}; smem --remove {(@1 ^z)}");
  for (Desk* desk : {&fourth, &fifth}) {
    desk->Do("sp {ask (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.kind k)}");
  }
  for (Desk* desk : {&first, &second, &third, &fourth, &fifth}) desk->Do("run 2");
  const auto memory = [](Desk& desk) -> kernel::SemanticMemory& {
    return kernel::SemanticMemory::Of(desk.agent.long_term());
  };
  EXPECT_EQ(&memory(first).knowledge(), &memory(second).knowledge());
  EXPECT_NE(&memory(first).knowledge(), &memory(third).knowledge());
  EXPECT_NE(&memory(first).knowledge(), &memory(fourth).knowledge());
  EXPECT_NE(&memory(first).knowledge(), &memory(fifth).knowledge());
  // Each agent has its own activation; an agent that stores something new gets its own layer.
  second.Do("smem --add {(@201 ^kind k)}");
  EXPECT_NE(&memory(first).knowledge(), &memory(second).knowledge());
  EXPECT_EQ(first.Do("smem --stats nodes"), " 200\n");
  EXPECT_EQ(second.Do("smem --stats nodes"), " 201\n");
  EXPECT_EQ(second.Do("print @200"), "(@200 ^kind k ^n 200 [+1.000])\n");
}

/// Agents with shared knowledge must behave like agents with their own copy, which they have because their memory is a
/// file.
TEST_F(SemanticMemoryTest, AgentsOverSharedKnowledgeAreEqualToAgentsAlone) {
  std::string facts;
  for (int n = 1; n <= 6000; ++n) {
    facts += fmt::format("(@{} ^kind k{} ^number {} ^next @{} ^text |a text of some length that nobody asks for|)\n", n,
                         n % 7, n % 50, n % 6000 + 1);
  }
  const std::string begin =
      "smem --enable; smem --add {" + facts +
      "}; trace 0; sp {cue (state <s> ^superstate nil ^smem.command <c>) --> (<c> ^query.number 7)}";
  struct Pair {
    explicit Pair(const fs::path& folder) : shared(folder), alone(folder) {}
    Desk shared, alone;
  };
  std::vector<std::unique_ptr<Pair>> pairs;
  for (int n = 0; n < 3; ++n) {
    const fs::path folder = folder_ / std::to_string(n);
    fs::create_directories(folder);
    pairs.push_back(std::make_unique<Pair>(folder));
    pairs.back()->shared.Do(begin);
    pairs.back()->alone.Do(kFile);
    pairs.back()->alone.Do(begin);
  }
  const auto memory = [](Desk& desk) -> kernel::SemanticMemory& {
    return kernel::SemanticMemory::Of(desk.agent.long_term());
  };
  // The text was read once.
  EXPECT_TRUE(memory(pairs[0]->shared).shares());
  EXPECT_EQ(&memory(pairs[0]->shared).knowledge(), &memory(pairs[2]->shared).knowledge());
  EXPECT_FALSE(memory(pairs[0]->alone).shares());
  std::mt19937 random(11);
  const auto any = [&](unsigned below) { return static_cast<int>(random() % below); };
  for (int step = 0; step < 400; ++step) {
    Pair& pair = *pairs[static_cast<std::size_t>(any(3))];
    const int object = 1 + any(6100), other = 1 + any(6100);
    std::string line;
    switch (any(7)) {
      case 0:
        line = fmt::format("smem --add {{(@{} ^kind k{} new{} ^next @{})}}", object, any(9), any(5), other);
        break;
      case 1:
        line = fmt::format("smem --add {{(<x> ^kind k{} ^number {})}}", any(9), any(60));
        break;
      case 2:
        line = any(2) == 0 ? fmt::format("smem --remove {{(@{} ^number)}}", object)
                           : fmt::format("smem --remove {{(@{})}}", object);
        break;
      case 3:
        line = fmt::format("smem --query {{(<q> ^kind k{} ^number {})}} 4", any(9), any(60));
        break;
      case 4:
        line = fmt::format("smem --query {{(<q> ^next @{} ^kind <any>)}}", object);
        break;
      case 5:
        line = fmt::format("print @{}", object);
        break;
      default:
        line = "run 1; print L1 --depth 3";
        break;
    }
    SCOPED_TRACE(line);
    ASSERT_EQ(pair.shared.Do(line), pair.alone.Do(line));
  }
  for (const auto& pair : pairs) {
    ASSERT_TRUE(memory(pair->shared).knowledge().is_layer());
    EXPECT_EQ(memory(pair->shared).knowledge().CheckInvariants(), "");
    EXPECT_LT(memory(pair->shared).knowledge().MemoryBytes(), memory(pair->alone).knowledge().MemoryBytes() / 20);
    pair->shared.Do("smem --export shared.soar");
    pair->alone.Do("smem --export alone.soar");
    EXPECT_EQ(Text(pair->shared.interpreter.Resolve("shared.soar")),
              Text(pair->alone.interpreter.Resolve("alone.soar")));
    EXPECT_EQ(pair->shared.Do("print @"), pair->alone.Do("print @"));
    // Saved and loaded contents are the same, too.
    pair->shared.Do("smem --backup copy.db");
    Desk again(folder_);
    again.Do("cd " + pair->shared.interpreter.Resolve(".").string());
    again.Do("smem --set path copy.db; smem --set database file; smem --enable");
    EXPECT_EQ(again.Do("print @"), pair->shared.Do("print @"));
  }
}

TEST_F(SemanticMemoryTest, OneObjectMayHaveVeryManyValues) {
  Desk desk(folder_);
  std::string values;
  for (int n = 0; n < 20000; ++n) values += " " + std::to_string(n);
  EXPECT_THAT(desk.Do("smem --add {(@1 ^n" + values + ")}"), HasSubstr("Knowledge added"));
  EXPECT_EQ(desk.Do("smem --stats edges"), " 20000\n");
  EXPECT_THAT(desk.Do("smem --query {(<q> ^n 19999)}"), HasSubstr("Query complete"));
}

}  // namespace
}  // namespace soarbox::cli
