// SPDX-License-Identifier: BSD-2-Clause
#include "sim/decision_clock.h"

#include <gtest/gtest.h>

namespace soarbox::sim {
namespace {

constexpr double kStep_s = 0.1;

TEST(DecisionClock, KnowsTheTickOfEachDecision) {
  DecisionClock clock;
  clock.Note(3, 0.1, kStep_s);  // Decisions 1 to 3.
  clock.Note(4, 0.2, kStep_s);
  clock.Note(5, 0.3, kStep_s);
  clock.Note(5, 0.4, kStep_s);  // None.
  clock.Note(6, 0.5, kStep_s);
  EXPECT_DOUBLE_EQ(clock.TimeOf(1).value(), 0.1);
  EXPECT_DOUBLE_EQ(clock.TimeOf(3).value(), 0.1);
  EXPECT_DOUBLE_EQ(clock.TimeOf(4).value(), 0.2);
  EXPECT_DOUBLE_EQ(clock.TimeOf(5).value(), 0.3);
  EXPECT_DOUBLE_EQ(clock.TimeOf(6).value(), 0.5);
}

TEST(DecisionClock, KnowsNothingOfDecisionsThatWereNotMade) {
  DecisionClock clock;
  EXPECT_FALSE(clock.TimeOf(1).has_value());
  clock.Note(2, 0.1, kStep_s);
  EXPECT_FALSE(clock.TimeOf(0).has_value());
  EXPECT_FALSE(clock.TimeOf(3).has_value());
}

TEST(DecisionClock, BeginsAgainWithItsMind) {
  DecisionClock clock;
  clock.Note(9, 0.1, kStep_s);
  clock.Note(2, 0.2, kStep_s);
  EXPECT_DOUBLE_EQ(clock.TimeOf(2).value(), 0.2);
  EXPECT_FALSE(clock.TimeOf(9).has_value());
}

TEST(DecisionClock, ForgetsTheOldestOfManyChanges) {
  DecisionClock clock;
  std::uint64_t decisions = 0;
  for (int tick = 1; tick <= 40'000; ++tick) clock.Note(decisions += 1 + tick % 2, tick * kStep_s, kStep_s);
  EXPECT_FALSE(clock.TimeOf(1).has_value());
  EXPECT_NEAR(clock.TimeOf(decisions).value(), 4'000, 1e-6);
}

}  // namespace
}  // namespace soarbox::sim
