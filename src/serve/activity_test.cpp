// SPDX-License-Identifier: BSD-2-Clause
#include "serve/activity.h"

#include <gtest/gtest.h>

namespace soarbox::serve {
namespace {

using std::chrono::seconds;

constexpr const char* kWrong =
    R"({"message":"contents","contents":{"edit":{"edit":{"file":"/place/home/porter.soar","problems":[)"
    R"({"severity":"warning","message":"odd"},{"severity":"error","line":4,"message":"a ( is still open"}]}}}})";
constexpr const char* kRight =
    R"({"message":"contents","contents":{"edit":{"edit":{"file":"porter.soar","problems":[]}}}})";
constexpr const char* kPassed = R"({"message":"contents","contents":{"mission":{"lesson":{"is_passed":true}}}})";

PageMessage Grade() {
  PageMessage message;
  message.request = "lesson";
  message.what = "grade";
  return message;
}

TEST(Activity, ALearnerWithAnErrorIsStuckAfterTwoMinutes) {
  Activity activity;
  const Activity::Time begin;
  activity.Begin("lesson:01-a-rule", begin);
  activity.Look(kWrong, {}, {}, begin + seconds(10));
  const Activity::Standing soon = activity.At(begin + seconds(20));
  EXPECT_EQ(soon.kind, Activity::Kind::kMistake);
  EXPECT_EQ(soon.text, "error in porter.soar, line 4: a ( is still open");
  activity.Look(kWrong, {}, {}, begin + seconds(100));
  const Activity::Standing later = activity.At(begin + seconds(140));
  EXPECT_EQ(later.kind, Activity::Kind::kStuck);
  EXPECT_EQ(later.lasts, seconds(130));
  activity.Look(kRight, {}, {}, begin + seconds(150));
  EXPECT_EQ(activity.At(begin + seconds(151)).kind, Activity::Kind::kWorks);
}

TEST(Activity, ThreeGradesWithoutAPassAreStuckSinceTheFirst) {
  Activity activity;
  const Activity::Time begin;
  activity.Begin("lesson:02-operators", begin);
  for (int i = 1; i <= 3; ++i) activity.NoteRequest(Grade(), begin + seconds(10 * i));
  const Activity::Standing stuck = activity.At(begin + seconds(60));
  EXPECT_EQ(stuck.kind, Activity::Kind::kStuck);
  EXPECT_EQ(stuck.text, "graded 3 times, not passed");
  EXPECT_EQ(stuck.lasts, seconds(50));
  // The same lesson from its beginning; then it is passed.
  activity.Begin("lesson:02-operators", begin + seconds(61));
  EXPECT_EQ(activity.At(begin + seconds(62)).grades, 3);
  activity.Look({}, {}, kPassed, begin + seconds(70));
  EXPECT_EQ(activity.At(begin + seconds(71)).kind, Activity::Kind::kWorks);
  activity.Begin("lesson:03-choices", begin + seconds(80));
  EXPECT_EQ(activity.At(begin + seconds(81)).grades, 0);
}

TEST(Activity, WhoAsksForNothingForTenMinutesIsIdleAndPagesThatLookDoNotCount) {
  Activity activity;
  const Activity::Time begin;
  activity.Begin("scenario:eaters", begin);
  PageMessage look;
  look.request = "look";
  activity.NoteRequest(look, begin + seconds(500));
  EXPECT_EQ(activity.At(begin + seconds(599)).kind, Activity::Kind::kWorks);
  EXPECT_EQ(activity.At(begin + seconds(600)).kind, Activity::Kind::kIdle);
  activity.Look("no JSON", "[1]", R"({"contents":[]})", begin + seconds(601));
  EXPECT_EQ(activity.At(begin + seconds(601)).text, "has done nothing here");
}

}  // namespace
}  // namespace soarbox::serve
