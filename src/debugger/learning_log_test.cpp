// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/learning_log.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "debugger/learned_rule.h"
#include "debugger/learning.h"
#include "debugger/mind_fixture.h"
#include "debugger/recorded_mind.h"
#include "debugger/run_models.h"
#include "debugger/view_fields.h"
#include "debugger/views.h"

namespace soarbox::debugger {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using LearnedRules = MindFixture;

/// Looks up the price of a pear in a substate. The rule that is learned there also gives the price of a fig, without a
/// substate.
constexpr const char* kShopper = R"(
chunk always
sp {hero*init (state <s> ^superstate nil) --> (<s> ^tag <t1> ^tag <t2>)
   (<t1> ^fruit pear ^cents 40) (<t2> ^fruit fig ^cents 75)}
sp {hero*propose*pear (state <s> ^superstate nil ^tag.fruit pear -^cost) --> (<s> ^operator <o> +) (<o> ^name price ^fruit pear)}
sp {hero*propose*fig (state <s> ^superstate nil ^cost 40 -^cost 75)
   --> (<s> ^operator <o> +) (<o> ^name price ^fruit fig)}
sp {hero*propose*rest (state <s> ^superstate nil ^cost 75) --> (<s> ^operator <o> +) (<o> ^name rest)}
sp {hero*price*copy (state <ss> ^superstate <s>) (<s> ^operator <o>) (<o> ^name price ^fruit <f>) --> (<ss> ^wanted <f>)}
sp {hero*price*look (state <ss> ^superstate <s> ^wanted <f>) (<s> ^operator.name price ^tag <t>)
   (<t> ^fruit <f> ^cents <c>) --> (<s> ^cost <c>)}
)";

/// Gets a reward of 1 in each turn. An episode has 5 turns.
constexpr const char* kEarner = R"(
rl --set learning on
rl --set temporal-extension off
decide indifferent-selection --first
sp {hero*init (state <s> ^superstate nil) --> (<s> ^turn 0)}
sp {hero*propose*go (state <s> ^superstate nil ^turn { <n> < 3 }) --> (<s> ^operator <o> +) (<o> ^name go ^turn <n>)}
sp {hero*apply*go (state <s> ^operator <o> ^turn <n>) (<o> ^name go ^turn <n>) --> (<s> ^turn <n> - (+ <n> 1))}
sp {hero*propose*home (state <s> ^superstate nil ^turn 3) --> (<s> ^operator <o> +) (<o> ^name home)}
sp {hero*apply*home (state <s> ^operator.name home) --> (<s> ^turn 3 - 0)}
sp {hero*value (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 0.0)}
sp {hero*reward (state <s> ^superstate nil ^reward-link <r> ^turn > 0) --> (<r> ^reward.value 1)}
)";

template <typename... Events>
record::MindRecord Did(const Events&... events) {
  record::MindRecord mind;
  (mind.events.Add(events), ...);
  return mind;
}

TEST(LearningLog, ReadsWhatIsToldAmongDecisionsAndForgetsWhatDidNotHappen) {
  LearningLog log;
  using mind::RuleFired;
  log.Add(3, Did(mind::StateMade{1, "S1", mind::StateReason::kTop, false, {}},
                 mind::RuleLearned{2, "chunk*a", "a", "S2", mind::StateReason::kTie, true}, RuleFired{"chunk*a", false},
                 mind::ValueUpdated{"rl*one", -1.5}, RuleFired{"b", false}));
  log.Add(5, Did(RuleFired{"chunk*a", false}, RuleFired{"chunk*a", true}, mind::RewardReceived{2},
                 mind::ValueUpdated{"rl*one", 0.25}, mind::OperatorSelected{1, "O1", "go", {}}));
  log.Add(7, Did(mind::RewardReceived{-0.5}, mind::EpisodeEnded{}));
  log.Add(9, Did(mind::RewardReceived{4}));
  ASSERT_EQ(log.rules().size(), 1u);
  EXPECT_EQ(log.rules()[0].name, "chunk*a");
  EXPECT_EQ(log.rules()[0].reason, "from a in S2 (operator tie)");
  EXPECT_THAT(log.Find("chunk*a")->fired, ElementsAre(3u, 5u));
  EXPECT_EQ(log.Find("b"), nullptr);
  EXPECT_EQ(log.values().at("rl*one").back(), std::pair(std::uint64_t{5}, 0.25));
  EXPECT_EQ(log.rewards().back().second, 5.5);
  ASSERT_EQ(log.episodes().size(), 1u);
  EXPECT_EQ(log.episodes()[0].reward, 1.5);
  EXPECT_EQ(log.episodes()[0].first_tick, 5u);
  log.CutFrom(9);
  log.Add(9, Did(mind::RewardReceived{1}, mind::EpisodeEnded{}));
  ASSERT_EQ(log.episodes().size(), 2u);
  EXPECT_EQ(log.episodes()[1].reward, 1);
  log.CutFrom(5);
  EXPECT_THAT(log.Find("chunk*a")->fired, ElementsAre(3u));
  EXPECT_EQ(log.values().at("rl*one").back().second, -1.5);
  EXPECT_THAT(log.episodes(), IsEmpty());
  log.CutFrom(3);
  EXPECT_TRUE(log.empty());
  EXPECT_EQ(log.Find("chunk*a"), nullptr);
}

TEST(LearningLog, KeepsTheNewestOfManyRulesAndThinsLongCurvesOut) {
  LearningLog log;
  for (std::uint64_t tick = 1; tick <= 21'000; ++tick) {
    const std::string rule = "c" + std::to_string(tick);
    log.Add(tick, Did(mind::RuleLearned{1, rule, {}, {}, mind::StateReason::kNoChange, false},
                      mind::ValueUpdated{"v", static_cast<double>(tick)}));
  }
  EXPECT_EQ(log.rules().size(), 20'000u);
  EXPECT_EQ(log.Find("c1000"), nullptr);
  EXPECT_EQ(log.Find("c1001")->tick, 1001u);
  const LearningLog::Points& points = log.values().at("v");
  EXPECT_LE(points.size(), 1000u);
  EXPECT_EQ(points.front().first, 1u);
  EXPECT_EQ(points.back().second, 21'000);
}

TEST_F(LearnedRules, TellWhenARuleWasLearnedFromWhatAndWhatItIsGoodFor) {
  Start(kShopper);
  RunModels models;
  for (int tick = 0; tick < 6; ++tick) models.Add(Tick());
  const LearningLog& log = models.learning["hero"];
  ASSERT_EQ(log.rules().size(), 1u);
  const LearnedRule& learned = log.rules()[0];
  EXPECT_THAT(learned.name, HasSubstr("chunk*hero*price*look"));
  EXPECT_THAT(learned.reason, HasSubstr("from hero*price*look in S2 (operator no-change)"));
  EXPECT_FALSE(learned.fired.empty()) << "it knew the price of the fig";
  const auto mind = Mind();
  const LearningView view = LookAtLearning(*mind, {}, &log);
  ASSERT_EQ(view.rules.size(), 1u);
  EXPECT_EQ(view.rules[0].tick, learned.tick);
  EXPECT_EQ(view.rules[0].purpose, "makes ^cost");
  EXPECT_EQ(view.rules[0].source, "S2: operator no-change in S1, where price was selected");
  EXPECT_GT(view.rules[0].firings, 0u);
  EXPECT_THAT(ToText(view), AllOf(HasSubstr("it makes ^cost"), HasSubstr("operator no-change in S1")));
  EXPECT_EQ(JsonOf(view)["rules"][0]["purpose"], "makes ^cost");
  EXPECT_FALSE(LookAtLearning(*mind, "^cost", &log).rules.empty()) << "found by what it does";
  EXPECT_TRUE(LookAtLearning(*mind, "mortar", &log).rules.empty());
  EXPECT_FALSE(LookAtLearning(*mind, {}, &log, 0).rules[0].tick) << "it was not learned by then";
  bool has_mark = false;
  for (const TimelineMark& mark : models.timeline.Find("hero")->marks)
    has_mark |= mark.kind == MarkKind::kLearned && mark.text == "learned " + learned.name;
  EXPECT_TRUE(has_mark);
}

TEST_F(LearnedRules, TellWhyEachConditionIsThere) {
  Start(kShopper);
  RunModels models;
  for (int tick = 0; tick < 6; ++tick) models.Add(Tick());
  const auto mind = Mind();
  const std::string rule = models.learning["hero"].rules()[0].name;
  const LearnedRuleView view = LookAtLearnedRule(*mind, rule, &models.learning["hero"]);
  EXPECT_EQ(view.name, rule);
  EXPECT_FALSE(view.fired.empty());
  const std::string text = ToText(view);
  for (const char* part :
       {"in the substate S2 (operator no-change in S1, where price was selected)",
        "what it is good for: it makes ^cost", "^fruit pear)", "tested by hero*price*copy (firing",
        "which led to hero*price*look", "which gave the result", "of the substate, made by", "fired since, by ticks:"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_EQ(JsonOf(view)["why"]["kind"], "learned");
  EXPECT_TRUE(LookAtLearnedRule(*mind, "hero*price*look", nullptr).name.empty()) << "written, not learned";
}

TEST_F(LearnedRules, FollowWhatALearnedRuleMadeBackToTheSubstate) {
  Start(kShopper);
  RunModels models;
  for (int tick = 0; tick < 6; ++tick) models.Add(Tick());
  const std::string rule = models.learning["hero"].rules()[0].name;
  const Result<WhyNode> why = WhyName(*simulation_, "hero", rule);
  ASSERT_TRUE(why.ok());
  EXPECT_EQ(why->kind, WhyKind::kLearned);
  const auto mind = Mind();
  std::uint64_t timetag = 0;
  for (const explain::ElementFact& element : mind->ElementsOf("S1")) {
    if (element.attribute == "cost" && element.value == "75") timetag = element.timetag;
  }
  const std::string origin = ToText(WhyElement(*mind, timetag));
  EXPECT_THAT(origin, HasSubstr("in the substate S2 (operator no-change in S1, where price was selected)"));
  EXPECT_THAT(origin, HasSubstr("from hero*price*look (firing"));
  EXPECT_THAT(origin, HasSubstr("which rested on hero*price*copy (firing"));
  ViewSource source{simulation_.get(), &models, &record_};
  EXPECT_THAT(ShowView(source, {"learning", "hero", "#" + rule})->text, HasSubstr("why each condition is there"));
  EXPECT_FALSE(ShowView(source, {"learning", "hero", "#chunk*nothing"}).ok());
}

TEST_F(LearnedRules, OfARecordingAreToldBeforeItIsSimulatedAgain) {
  Start(kShopper);
  RunModels models;
  RecordedMinds minds(record::Level::kDecisions);
  for (int tick = 0; tick < 6; ++tick) {
    models.Add(Tick());
    minds.Add(record_);
  }
  const std::unique_ptr<explain::Inspector> mind = minds.Inspect("hero");
  const LearningLog& log = models.learning["hero"];
  const LearningView view = LookAtLearning(*mind, {}, &log);
  ASSERT_EQ(view.rules.size(), 1u);
  EXPECT_THAT(view.rules[0].source, HasSubstr("from hero*price*look"));
  EXPECT_THAT(view.note, HasSubstr("As recorded."));
  EXPECT_TRUE(LookAtLearning(*mind, {}, &log, 0).rules.empty());
  EXPECT_THAT(ToText(LookAtLearnedRule(*mind, view.rules[0].name, &log)), HasSubstr("not recorded"));
}

TEST_F(LearnedRules, ByRewardAreNotedWithEachEpisode) {
  Start(kEarner);
  RunModels models;
  for (int tick = 0; tick < 12; ++tick) models.Add(Tick());
  const LearningLog& log = models.learning["hero"];
  ASSERT_TRUE(log.values().contains("hero*value"));
  const LearningView view = LookAtLearning(*Mind(), {}, &log);
  EXPECT_NEAR(log.values().at("hero*value").back().second, view.numbers[0].value, 1e-4);
  EXPECT_NEAR(log.rewards().back().second, view.total_reward, 1e-4);
  ASSERT_GE(log.episodes().size(), 1u);
  EXPECT_EQ(log.episodes()[0].reward, 3) << "after each of three turns";
  EXPECT_THAT(ToText(log.episodes()), HasSubstr("episode 1: reward 3, "));
  for (const TimelineMark& mark : models.timeline.Find("hero")->marks) {
    EXPECT_THAT(mark.text, Not(HasSubstr("value "))) << "numbers are not events";
  }
}

TEST(PurposeOf, PutsActionsIntoWords) {
  explain::LearnedRuleFact learned;
  const auto action = [](const char* id, const char* attribute, const char* value, const char* sign,
                         const char* other) {
    explain::TripleFact fact;
    fact.id = id;
    fact.attribute = attribute;
    fact.value = value;
    fact.sign = sign;
    fact.referent = other;
    return fact;
  };
  learned.actions = {action("<s>", "operator", "<o>", "+", ""), action("<o>", "name", "go", "+", ""),
                     action("<o>", "to", "<g>", "+", "")};
  EXPECT_EQ(PurposeOf(learned), "proposes go");
  learned.conditions = {action("<p>", "name", "stay", "", "")};
  learned.actions = {action("<s>", "operator", "<o>", ">", "<p>")};
  EXPECT_EQ(PurposeOf(learned), "prefers the operator <o> to stay");
  learned.actions = {action("<s>", "operator", "<p>", "=", "1.5"), action("<s>", "done", "yes", "+", "")};
  EXPECT_EQ(PurposeOf(learned), "gives stay the value 1.5, makes ^done yes");
  learned.actions = {action("<s>", "operator", "<p>", "-", "")};
  EXPECT_EQ(PurposeOf(learned), "rejects stay");
}

}  // namespace
}  // namespace soarbox::debugger
