// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "cli/fence.h"
#include "cli/interpreter.h"
#include "cli/session.h"
#include "kernel/agent.h"
#include "kernel/learn/rl_settings.h"

namespace soarbox::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kRules[] = {
    "sp {init (state <s> ^superstate nil) --> (<s> ^turn 0)}",
    "sp {propose (state <s> ^superstate nil ^turn <n>) --> (<s> ^operator <o> + =) (<o> ^name go ^turn <n>)}",
    "sp {apply (state <s> ^operator.name go ^turn <n>) --> (<s> ^turn <n> - (+ <n> 1))}",
    "sp {learner (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 0.5)}",
    "sp {reward (state <s> ^reward-link <r> ^turn > 0) --> (<r> ^reward.value 2)}",
};

class CommandRlTest : public testing::Test {
 protected:
  CommandRlTest() {
    folder_ = std::filesystem::temp_directory_path() /
              ("soarbox_rl_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  ~CommandRlTest() override { std::filesystem::remove_all(folder_); }

  CommandResult Do(const std::string& line) { return interpreter_.Execute(session_, line); }
  void Load() {
    for (const char* const rule : kRules) EXPECT_TRUE(Do(rule).ok) << rule;
    EXPECT_TRUE(Do("rl --set learning on").ok);
  }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  static std::string Read(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }

  std::filesystem::path folder_;
  kernel::Agent agent_{"soar"};
  Session session_{agent_};
  Interpreter interpreter_;
};

TEST_F(CommandRlTest, LearnedNumbersAndSettingsOutliveSavingAndLoading) {
  Load();
  Do("rl --set apoptosis-thresh 3");
  Do("rl --set apoptosis rl-chunks");
  Do("rl --set discount-rate 0.8");
  Do("run 3");
  EXPECT_THAT(Do("print --rl").text, StartsWith("learner  2.000000 "));
  const std::string before = Do("print learner").text;
  EXPECT_THAT(before, HasSubstr("= 1.6"));
  ASSERT_TRUE(Do("save agent " + Path("agent.soar")).ok);
  ASSERT_TRUE(Do("save rete-network --save " + Path("agent.rete")).ok);

  kernel::Agent other("other");
  Session session(other);
  EXPECT_TRUE(interpreter_.Execute(session, "source " + Path("agent.soar")).ok);
  EXPECT_EQ(interpreter_.Execute(session, "print learner").text, before);
  EXPECT_EQ(interpreter_.Execute(session, "rl").text, Do("rl").text);
  EXPECT_TRUE(other.reinforcement().learning);

  kernel::Agent third("third");
  Session images(third);
  ASSERT_TRUE(interpreter_.Execute(images, "load rete-network --load " + Path("agent.rete")).ok);
  EXPECT_EQ(interpreter_.Execute(images, "print learner").text, before);
}

TEST_F(CommandRlTest, UpdatesAreWrittenToALogAndAFileThatCannotBeWrittenIsAnError) {
  Load();
  EXPECT_THAT(Do("rl --set update-log-path " + Path("no/such/folder/log.txt")).text, HasSubstr("Cannot write to"));
  EXPECT_EQ(Do("rl --get update-log-path").text, "");
  ASSERT_TRUE(Do("rl --set update-log-path " + Path("log.txt")).ok);
  Do("run 3");
  EXPECT_THAT(Read(Path("log.txt")),
              StartsWith("RL update learner 0 0.5 0.5 -> 0.6 0.485 1.085\nRL update learner 0.6"));
}

TEST_F(CommandRlTest, AStrangersFilesMayLearnButNotWriteALog) {
  const auto refusal = [](const std::string& line) {
    std::vector<Word> words;
    std::istringstream text(line);
    for (std::string word; text >> word;) words.emplace_back().text = word;
    return Fence({}).Ask(words).refusal;
  };
  EXPECT_EQ(refusal("rl --set learning on"), "");
  EXPECT_NE(refusal("rl --set update-log-path /tmp/log"), "");
}

TEST_F(CommandRlTest, NumbersAreReadAsSoarReadsThem) {
  EXPECT_TRUE(Do("rl --set learning-rate fast").ok);
  EXPECT_EQ(agent_.reinforcement().learning_rate, 0);
  EXPECT_TRUE(Do("rl --set learning-rate 0.25").ok);
  EXPECT_EQ(agent_.reinforcement().learning_rate, 0.25);
  EXPECT_FALSE(Do("rl --set learning-rate 1.5").ok);
  EXPECT_FALSE(Do("rl --set eligibility-trace-tolerance 0").ok);
  EXPECT_FALSE(Do("rl --set learning").ok);
  EXPECT_FALSE(Do("rl --get learning now").ok);
  EXPECT_EQ(Do("rl --stats global-reward").text, "0");
  EXPECT_FALSE(Do("rl --stats nothing").ok);
}

TEST_F(CommandRlTest, ChoicesGrowATreeWithTheirChances) {
  Do("sp {go (state <s> ^superstate nil) --> (<s> ^operator <a> + = ^operator <b> + =) (<a> ^name left) (<b> ^name "
     "right)}");
  Do("sp {worth (state <s> ^operator <o> +) (<o> ^name right) --> (<s> ^operator <o> = 3)}");
  Do("sp {less (state <s> ^operator <o> +) (<o> ^name left) --> (<s> ^operator <o> = 1)}");
  Do("decide indifferent-selection --first");
  Do("rl --set learning on");
  Do("rl --set trace on");
  Do("run 1");
  const std::string graph = Do("rl --trace").text;
  EXPECT_THAT(graph, HasSubstr("0 -> 1 [label=\"^name left\\n0 (0)\"]"));
  EXPECT_THAT(graph, HasSubstr("0 -> 2 [label=\"^name right\\n1 (0)\"]"));
  EXPECT_EQ(Do("rl --trace print 2").text, "# RL Trace, Goal Level 2:\n");
  EXPECT_FALSE(Do("rl --trace clear 0").ok);
  EXPECT_TRUE(Do("rl --trace clear").ok);
  EXPECT_EQ(Do("rl --trace").text, "# RL Trace, Goal Level 1:\n");
}

}  // namespace
}  // namespace soarbox::cli
