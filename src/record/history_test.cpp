// SPDX-License-Identifier: BSD-2-Clause
#include "record/history.h"

#include <gtest/gtest.h>

#include <random>

#include "record/ticks_test_support.h"

namespace soarbox::record {
namespace {

std::vector<std::uint64_t> TicksWithInputs(const std::vector<TickRecord>& ticks, std::uint64_t last) {
  std::vector<std::uint64_t> with;
  for (const TickRecord& tick : ticks)
    if (!tick.inputs.empty() && tick.tick <= last) with.push_back(tick.tick);
  return with;
}

std::vector<std::uint64_t> TicksWithInputs(History& history) {
  std::vector<std::uint64_t> with;
  const std::vector<TickInputs> inputs = history.Inputs().value();
  for (const TickInputs& entry : inputs) with.push_back(entry.tick);
  return with;
}

TEST(History, GivesAnyTickByNumberWhileItGrows) {
  const std::vector<TickRecord> ticks = SomeTicks(200);
  History history(SomeHeader());
  EXPECT_TRUE(history.empty());
  EXPECT_FALSE(history.At(0));
  std::mt19937 random(5);
  for (const TickRecord& tick : ticks) {
    history.Add(tick);
    ASSERT_EQ(history.last_tick(), tick.tick);
    for (int i = 0; i < 5; ++i) {
      const std::uint64_t wanted = i == 0 ? tick.tick : random() % (tick.tick + 1);
      const Result<const TickRecord*> read = history.At(wanted);
      ASSERT_TRUE(read) << Format(read.error());
      ASSERT_EQ(Bytes(**read), Bytes(ticks[wanted]));
    }
  }
  EXPECT_EQ(history.first_tick(), 0u);
  EXPECT_NE(history.At(200).error().hint.find("0 to 199"), std::string::npos);
  EXPECT_EQ(TicksWithInputs(history), TicksWithInputs(ticks, 199));
}

TEST(History, IsBoundedAndKeepsAllInputs) {
  const std::vector<TickRecord> ticks = SomeTicks(2000);
  History by_size(SomeHeader(), {.most_bytes = 120'000, .ticks_per_block = 10});
  History by_ticks(SomeHeader(), {.most_ticks = 100, .ticks_per_block = 10});
  for (const TickRecord& tick : ticks) {
    by_size.Add(tick);
    by_ticks.Add(tick);
    ASSERT_LE(by_size.bytes(), 120'000u);
  }
  EXPECT_GT(by_size.first_tick(), 0u);
  EXPECT_LT(by_size.first_tick(), 1970u);
  EXPECT_EQ(by_ticks.first_tick(), 1890u);
  for (History* history : {&by_size, &by_ticks}) {
    EXPECT_FALSE(history->At(history->first_tick() - 1));
    EXPECT_EQ(Bytes(**history->At(history->first_tick())), Bytes(ticks[history->first_tick()]));
    EXPECT_EQ(TicksWithInputs(*history), TicksWithInputs(ticks, 1999));
  }
}

TEST(History, ThePastOfABranchIsAHistoryThatGoesOnByItself) {
  const std::vector<TickRecord> ticks = SomeTicks(120);
  const std::vector<TickRecord> others = SomeTicks(120, 2);
  History history(SomeHeader());
  for (const TickRecord& tick : ticks) history.Add(tick);
  for (const std::uint64_t at : {0u, 29u, 30u, 47u, 119u}) {
    const std::unique_ptr<History> past = history.UpTo(at);
    ASSERT_EQ(past->last_tick(), at);
    EXPECT_EQ(TicksWithInputs(*past), TicksWithInputs(ticks, at));
    for (std::uint64_t next = at + 1; next < 120; ++next) past->Add(others[next]);
    for (std::uint64_t tick = 0; tick < 120; ++tick)
      ASSERT_EQ(Bytes(**past->At(tick)), Bytes(tick <= at ? ticks[tick] : others[tick])) << at << ", " << tick;
    ASSERT_EQ(Bytes(**history.At(119)), Bytes(ticks[119]));
  }
}

TEST(History, ABranchMayLeaveBeforeTheOldestRecord) {
  const std::vector<TickRecord> ticks = SomeTicks(400);
  History history(SomeHeader(), {.most_ticks = 60, .ticks_per_block = 10});
  for (const TickRecord& tick : ticks) history.Add(tick);
  const std::unique_ptr<History> past = history.UpTo(100);
  EXPECT_TRUE(past->empty());
  EXPECT_EQ(TicksWithInputs(*past), TicksWithInputs(ticks, 100));
  past->Add(ticks[101]);
  EXPECT_EQ(past->first_tick(), 101u);
}

}  // namespace
}  // namespace soarbox::record
