// SPDX-License-Identifier: BSD-2-Clause
#include "mind/mind_record.h"

#include <gtest/gtest.h>

namespace soarbox::mind {
namespace {

std::size_t CountOf(const MindRecord& record) {
  std::size_t count = 0;
  record.events.ForEach([&](const auto&) { ++count; });
  return count;
}

TEST(MindRecord, TheOperatorsAreThoseOfTheGoalStack) {
  MindRecord record;
  record.OnOperator({1, "O1", "engage", {}});
  record.OnState({2, "S2", StateReason::kNoChange, true, {}});
  record.OnOperator({2, "O2", {}, {}});
  EXPECT_EQ(record.Operators(), "engage > O2");
  record.OnStateGone({2, "S2"});
  EXPECT_EQ(record.Operators(), "engage");
  record.OnOperator({1, "O3", "flee", {}});
  record.Clear();
  EXPECT_EQ(record.Operators(), "flee") << "they stay selected in the next tick";
  EXPECT_TRUE(record.events.empty());
}

TEST(MindRecord, AProgramThatWaitsIsRecordedOnce) {
  MindRecord record;
  for (int cycle = 0; cycle < 3; ++cycle) record.OnState({1, "S1", StateReason::kNoChange, false, {}});
  EXPECT_EQ(CountOf(record), 1u);
  record.OnOperator({1, "O1", "go", {}});
  record.OnState({1, "S1", StateReason::kNoChange, false, {}});
  EXPECT_EQ(CountOf(record), 3u);
  record.ForgetWaiting();
  record.OnState({1, "S1", StateReason::kNoChange, false, {}});
  EXPECT_EQ(CountOf(record), 4u);
}

TEST(MindRecord, TheMakerOfACommandIsKnownInItsTick) {
  MindRecord record;
  record.OnCommand(7, "apply*go");
  record.OnCommand(8, {});
  record.OnCommand(9, "apply*turn");
  EXPECT_EQ(record.MakerOf(7), "apply*go");
  EXPECT_EQ(record.MakerOf(8), "");
  EXPECT_EQ(record.MakerOf(9), "apply*turn");
  record.Clear();
  EXPECT_EQ(record.MakerOf(7), "");
}

TEST(RuleOutput, TextAndFailuresAreLimited) {
  RuleOutput output;
  for (int i = 0; i < 300; ++i) {
    output.Write(std::string(1000, 'x'));
    output.NoteFailure("rule", "why");
  }
  EXPECT_LT(output.text.size(), RuleOutput::kMostText + 1000);
  EXPECT_EQ(output.failures.size(), RuleOutput::kMostFailures);
}

}  // namespace
}  // namespace soarbox::mind
