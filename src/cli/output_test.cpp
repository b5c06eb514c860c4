// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/interpreter.h"
#include "cli/session.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

class OutputTest : public testing::Test {
 protected:
  OutputTest() {
    session_.stream().SetSink([this](std::string_view text) { printed_ += text; });
    Do("sp {go (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name go)}");
  }
  CommandResult Do(const std::string& line) { return interpreter_.Execute(session_, line); }
  double Value(const CommandResult& result, std::string_view name) {
    for (const ResultNode& node : result.structured.children) {
      if (node.attributes.at(0).second == name) return std::stod(node.text);
    }
    ADD_FAILURE() << name;
    return -1;
  }

  kernel::Agent agent_{"soar"};
  Session session_{agent_};
  Interpreter interpreter_;
  std::string printed_;
};

TEST_F(OutputTest, TheConsoleShowsTraceAndAnswersOnce) {
  EXPECT_EQ(Do("output console").text, "console is off\n");
  testing::internal::CaptureStdout();
  Do("run 1");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  Do("output console on");
  testing::internal::CaptureStdout();
  Do("run 1; print s1");
  const std::string shown = testing::internal::GetCapturedStdout();
  EXPECT_THAT(shown, HasSubstr("     2:    ==>S: S2 (operator no-change)"));
  EXPECT_THAT(shown, HasSubstr("(S1 ^epmem E1 ^io I1"));
  EXPECT_EQ(shown.find("(S1 ^epmem E1 ^io I1"), shown.rfind("(S1 ^epmem E1 ^io I1"));
  EXPECT_EQ(Do("output console").text, "console is on\n");
  // Output of a program that prints to the standard output itself is not duplicated.
  session_.stream().SetSinkIsConsole(true);
  testing::internal::CaptureStdout();
  Do("run 1; print s1");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(OutputTest, RunsAreTimedFromTheStartAndPhasesOnDemand) {
  Do("run 20");
  CommandResult stats = Do("stats");
  EXPECT_GT(Value(stats, "statskernelcputime"), 0);
  EXPECT_EQ(Value(stats, "statsphasetimeproposephase"), 0);
  Do("init-soar; soar timers on");
  EXPECT_EQ(Value(Do("stats"), "statskernelcputime"), 0);
  Do("run 20");
  stats = Do("stats");
  const double propose = Value(stats, "statsphasetimeproposephase");
  EXPECT_GT(propose, 0);
  EXPECT_GT(Value(stats, "statskernelcputime"), propose);
  EXPECT_GE(Value(stats, "statstotalcputime"), Value(stats, "statskernelcputime"));
  EXPECT_GT(Value(stats, "statsmaxdecisioncycletimecycle"), 0);
  EXPECT_THAT(stats.text, HasSubstr("Phases:      Input   Propose   Decide   Apply    Output |     Totals\n"));
  Do("init-soar; soar timers off; run 5");
  EXPECT_EQ(Value(Do("stats"), "statstotalcputime"), 0);
  EXPECT_EQ(agent_.observed() & kernel::Mask(kernel::Event::kPhase), 0u) << "off costs nothing";
}

}  // namespace
}  // namespace soarbox::cli
