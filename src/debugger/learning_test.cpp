// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/learning.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "debugger/mind_fixture.h"
#include "debugger/plots.h"
#include "debugger/view_fields.h"
#include "explain/command_inspector.h"

namespace soarbox::debugger {
namespace {

using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;

using LearningPanel = MindFixture;

constexpr const char* kLearner = R"(
rl --set learning on
rl --set discount-rate 0
decide indifferent-selection --first
sp {hero*count (state <s> ^superstate nil) --> (<s> ^turn 0)}
sp {hero*propose (state <s> ^superstate nil ^turn <n>) --> (<s> ^operator <a> + = ^operator <b> + =)
   (<a> ^name stay ^turn <n>) (<b> ^name go ^turn <n>)}
sp {hero*apply (state <s> ^operator.turn <n> ^turn { <n> < 900 }) --> (<s> ^turn <n> - (+ <n> 1))}
sp {hero*reward (state <s> ^superstate nil ^reward-link <r>) --> (<r> ^reward.value 10)}
sp {hero*value*go (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 1.0)}
sp {hero*value*stay (state <s> ^operator <o> +) (<o> ^name stay) --> (<s> ^operator <o> = 2.0)}
sp {hero*learned :chunk (state <s> ^superstate nil ^turn 3) --> (<s> ^seen three)}
)";

TEST_F(LearningPanel, ShowsWhatRewardHasTaughtTheHighestFirst) {
  Start(kLearner);
  Tick(8);
  const auto mind = Mind();
  const LearningView view = LookAtLearning(*mind);
  EXPECT_TRUE(view.by_reward);
  EXPECT_EQ(view.last_reward, 10);
  ASSERT_EQ(view.numbers.size(), 2u);
  EXPECT_EQ(view.numbers[0].rule, "hero*value*go");
  EXPECT_EQ(view.numbers[0].when, "^name go");
  EXPECT_GT(view.numbers[0].updates, 0u);
  EXPECT_GT(view.numbers[0].value, 3);
  EXPECT_DOUBLE_EQ(view.numbers[0].value, view.numbers[0].current + view.numbers[0].future);
  EXPECT_EQ(view.numbers[1].value, 2) << "never chosen, and what its text says";
  EXPECT_DOUBLE_EQ(view.total_reward, 10.0 * static_cast<double>(view.numbers[0].updates));
  ASSERT_EQ(view.rules.size(), 1u);
  EXPECT_EQ(view.rules[0].firings, 1u);
  EXPECT_THAT(ToText(view), HasSubstr("hero*learned"));
  EXPECT_EQ(JsonOf(view)["numbers"][0]["rule"], "hero*value*go");
  EXPECT_TRUE(LookAtLearning(*mind, "stay").rules.empty());
  EXPECT_EQ(LookAtLearning(*mind, "stay").learners, 2u);
}

TEST_F(LearningPanel, SaysWhatEachRuleOfATemplateIsAbout) {
  Start(std::string(kLearner) +
        "sp {hero*each :template (state <s> ^operator <o> + ^turn <n>) (<o> ^name <name>)\n"
        "--> (<s> ^operator <o> = 0.0)}\n");
  Tick(4);
  const LearningView view = LookAtLearning(*Mind(), "rl*hero*each");
  ASSERT_FALSE(view.numbers.empty());
  EXPECT_THAT(view.numbers[0].when, AnyOf(HasSubstr("^turn "), HasSubstr("^name ")));
  EXPECT_THAT(ToText(view), HasSubstr("if ^"));
}

TEST_F(LearningPanel, SaysWhyNothingIsLearned) {
  Start("sp {hero*value (state <s> ^operator <o> +) --> (<s> ^operator <o> = 1)}");
  Tick();
  EXPECT_THAT(LookAtLearning(*Mind()).note, HasSubstr("rl --set learning on"));
  Start("rl --set learning on\nsp {hero*nothing (state <s> ^superstate nil) --> (<s> ^a b)}");
  Tick();
  EXPECT_THAT(LookAtLearning(*Mind()).note, HasSubstr("no rule can learn by reward"));
}

TEST_F(LearningPanel, NumbersAndRewardCanBePlotted) {
  Start(kLearner);
  Tick();
  EXPECT_THAT(Plottable(*Mind()), Contains("learned:hero*value*go"));
  Plots plots;
  EXPECT_TRUE(plots.Plot("hero", "learned:hero*value*go"));
  EXPECT_TRUE(plots.Plot("hero", "reward"));
  for (int tick = 0; tick < 6; ++tick) {
    plots.Add(Tick());
    plots.Sample(*simulation_);
  }
  const PlotSeries& number = plots.series()[0];
  ASSERT_EQ(number.points.size(), 6u);
  EXPECT_LT(number.points.front().value, number.points.back().value);
  EXPECT_LT(plots.series()[1].points.front().value, plots.series()[1].points.back().value);
}

TEST(LearningFacts, AreReadFromWhatAKernelPrints) {
  const std::vector<explain::NumberFact> numbers =
      explain::ReadNumbers("b*new  2.000000 -1.250000\na*old  0.000000 2\n");
  ASSERT_EQ(numbers.size(), 2u);
  EXPECT_EQ(numbers[0].rule, "a*old");
  EXPECT_EQ(numbers[1].updates, 2u);
  EXPECT_EQ(numbers[1].value, -1.25);
}

}  // namespace
}  // namespace soarbox::debugger
