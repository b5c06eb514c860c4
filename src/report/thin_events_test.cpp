// SPDX-License-Identifier: BSD-2-Clause
#include "report/thin_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace soarbox::report {
namespace {

TEST(Thin, ATextIsCutBetweenCharacters) {
  EXPECT_EQ(CutText("short", 5), "short");
  EXPECT_EQ(CutText("much too long", 8), "much ...");
  EXPECT_EQ(CutText("a\xc3\xa4\xc3\xa4\xc3\xa4 and more", 8), "a\xc3\xa4 ...") << "no half of a character";
}

TEST(Thin, OfManyEventsRareOnesStayAndTheOthersAreSpreadOverTheRun) {
  std::vector<StoryEvent> events;
  for (int i = 0; i < 10'000; ++i) {
    if (i == 7000) events.push_back({7000, "a", "news", "dies"});
    events.push_back({static_cast<double>(i), "a", "print", "here I am"});
  }
  ThinEvents(events, 60'000);
  EXPECT_LT(events.size(), 1300U);
  EXPECT_GT(events.size(), 500U);
  EXPECT_EQ(std::ranges::count(events, "news", &StoryEvent::kind), 1);
  EXPECT_TRUE(std::ranges::is_sorted(events, {}, &StoryEvent::time_s));
  EXPECT_EQ(events.front().time_s, 0);
  EXPECT_GT(events.back().time_s, 9900);
  const std::size_t before = events.size();
  ThinEvents(events, 60'000);
  EXPECT_EQ(events.size(), before) << "what is small enough stays";
}

TEST(Thin, AnEventThatIsTheLastOfItsKindStays) {
  std::vector<StoryEvent> events{{0, "a", "print", std::string(1000, 'x')}};
  ThinEvents(events, 10);
  EXPECT_EQ(events.size(), 1U);
}

TEST(Thin, SpansNarrowerThanAColumnAreDrawnTogetherAndOthersStay) {
  std::vector<StorySpan> spans;
  for (int i = 0; i < 1000; ++i) {
    const double at = i * 0.1;
    spans.push_back({0, at, at + (i % 4 == 2 ? 0.09 : 0.05), i % 4 == 2 ? "walk" : "look"});
  }
  spans.push_back({1, 10, 60, "wait"});
  spans.push_back({0, 100, 130, "rest"});
  const std::vector<StorySpan> merged = MergeSpans(spans, 130, 130);
  ASSERT_GT(merged.size(), 100U);
  EXPECT_LT(merged.size(), 110U);
  EXPECT_EQ(merged[0].name, "walk and 9 more");
  EXPECT_EQ(merged[0].from_s, 0);
  EXPECT_LT(merged[0].to_s, 1);
  EXPECT_EQ(merged.back().name, "rest");
  EXPECT_EQ(std::ranges::count(merged, "wait", &StorySpan::name), 1);
}

TEST(Thin, AWayKeepsItsEndsAndBeginsWhenItsAgentCame) {
  StoryWay way;
  way.from = 3;
  for (int i = 0; i < 8; ++i) {
    way.x_cm.push_back(100 + i);
    way.z_cm.push_back(0);
    way.health.push_back(100);
    way.speed_dmps.push_back(i);
  }
  const std::vector<std::size_t> kept = KeptMoments(11, 4);
  EXPECT_EQ(kept, (std::vector<std::size_t>{0, 4, 8, 10}));
  const StoryWay thin = ThinWay(way, kept);
  EXPECT_EQ(thin.from, 1U);
  EXPECT_EQ(thin.x_cm, (std::vector<std::int32_t>{101, 105, 107}));
  EXPECT_EQ(thin.speed_dmps, (std::vector<std::int32_t>{1, 5, 7}));
  EXPECT_EQ(KeptMoments(3, 1).size(), 3U);
  EXPECT_TRUE(KeptMoments(0, 2).empty());
}

TEST(Thin, DifferencesAddUpToTheNumbers) {
  const std::vector<std::int32_t> numbers{500, 510, 490, 490};
  std::vector<std::int32_t> differences = Differences(numbers);
  EXPECT_EQ(differences, (std::vector<std::int32_t>{500, 10, -20, 0}));
  std::partial_sum(differences.begin(), differences.end(), differences.begin());
  EXPECT_EQ(differences, numbers);
}

}  // namespace
}  // namespace soarbox::report
