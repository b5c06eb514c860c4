// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/rete.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/match/match_test_support.h"

namespace soarbox::kernel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr bool kO = true;
constexpr bool kI = false;

class ReteTest : public testing::Test, public MatchFixture {
 protected:
  ReteTest() {
    SetGoal("S1", 1);
    SetGoal("S2", 2);
  }
  TestDraft Is(std::string_view word) { return Equal(Word(word)); }
  /// (<s> ^attribute value) with <s> a goal.
  ConditionDraft OnState(std::string_view attribute, std::string_view value) {
    return Positive(Both(Is("<s>"), Relation(TestKind::kState, Symbol())), Is(attribute), Is(value));
  }
  ActionDraft Make(BindingSite id, std::string_view attribute) {
    ActionDraft action;
    action.id.kind = RhsValueKind::kBound;
    action.id.site = id;
    action.attribute.symbol = Word(attribute);
    action.value.symbol = Word("x");
    return action;
  }
};

TEST_F(ReteTest, TheFirstLoadedRuleIsTakenFirstWhenAnElementArrivesAndTheLastWhenItWasThere) {
  const ProductionPtr a = Rule("a", {OnState("x", "1")});
  const ProductionPtr b = Rule("b", {OnState("x", "1")}, {Make({0, Field::kId}, "y")});
  AddRule(a);
  AddRule(b);
  Add("S1", "x", "1");
  EXPECT_THAT(FireAll(), ElementsAre("a", "b"));
  const ProductionPtr c = Rule("c", {OnState("x", "1")}, {Make({0, Field::kId}, "c")});
  const ProductionPtr d = Rule("d", {OnState("x", "1")}, {Make({0, Field::kId}, "d")});
  AddRule(c);
  AddRule(d);
  EXPECT_THAT(FireAll(), ElementsAre("d", "c"));
}

TEST_F(ReteTest, ARuleWithTheSameConditionsAndActionsIsADuplicate) {
  const ProductionId first = AddRule(Rule("a", {OnState("x", "<v>")}));
  const Rete::Added again = rete.AddProduction(Rule("b", {OnState("x", "<other>")}), Goals());
  EXPECT_EQ(again.result, Rete::AddResult::kDuplicate);
  EXPECT_EQ(again.production, first);
}

TEST_F(ReteTest, AMatchThatComesBackBeforeItsRetractionStaysFired) {
  AddRule(Rule("a", {OnState("x", "1"), Negative(Is("<s>"), Is("y"), TestDraft())}));
  Add("S1", "x", "1");
  ASSERT_THAT(FireAll(), ElementsAre("a"));
  const WmeId blocker = Add("S1", "y", "1");
  EXPECT_TRUE(rete.matches().HasRetractions(1));
  Remove(blocker);
  EXPECT_FALSE(rete.matches().HasRetractions(1));
  EXPECT_THAT(FireAll(), IsEmpty());
}

TEST_F(ReteTest, AMatchOfANewElementDoesNotReplaceTheRetractionOfAnOldOneInTheSamePlace) {
  AddRule(Rule("a", {OnState("x", "1"), Negative(Is("<s>"), Is("y"), TestDraft())}));
  const WmeId old = Add("S1", "x", "1");
  ASSERT_THAT(FireAll(), ElementsAre("a"));
  const WmeId blocker = Add("S1", "y", "1");
  Remove(old);
  ASSERT_EQ(Add("S1", "x", "1"), old) << "the table uses the place again";
  Remove(blocker);
  EXPECT_TRUE(rete.matches().HasRetractions(1));
  EXPECT_THAT(FireAll(), ElementsAre("a"));
}

TEST_F(ReteTest, RetractionsOfAGoalThatGoesAreKeptWithoutGoal) {
  AddRule(Rule("a", {OnState("x", "<v>")}));
  const WmeId first = Add("S2", "x", "1");
  const WmeId second = Add("S2", "x", "2");
  ASSERT_EQ(FireAll().size(), 2u);
  Remove(first);
  EXPECT_TRUE(rete.matches().HasRetractions(2));
  rete.matches().GoalRemoved(2);
  Remove(second);
  EXPECT_FALSE(rete.matches().HasRetractions(2));
  const MatchId newest = rete.matches().TakeRetraction(0);
  EXPECT_EQ(wmes[Index(rete.Wmes(newest)[0])].value, Word("2"));
  EXPECT_NE(rete.matches().TakeRetraction(0), MatchId::kNone);
  EXPECT_FALSE(rete.matches().HasNoGoalRetractions());
}

TEST_F(ReteTest, AssertionsPutBackAreTakenAgainInTheSameOrder) {
  AddRule(Rule("a", {OnState("x", "<v>")}));
  Add("S1", "x", "1");
  Add("S1", "x", "2");
  const PendingMatch first = rete.matches().TakeAssertion(1, kI);
  const PendingMatch second = rete.matches().TakeAssertion(1, kI);
  rete.matches().PutBack(std::vector<MatchId>{first.match, second.match});
  EXPECT_EQ(rete.matches().TakeAssertion(1, kI).match, first.match);
  EXPECT_EQ(rete.matches().TakeAssertion(1, kI).match, second.match);
}

TEST_F(ReteTest, TestingTheSelectedOperatorOfTheLowestGoalGivesOSupport) {
  const ProductionPtr apply = Rule("apply", {OnState("operator", "<o>")}, {Make({0, Field::kId}, "done")});
  const ProductionPtr elaborate = Rule("elaborate", {OnState("operator", "<o>")}, {Make({0, Field::kValue}, "done")});
  const ProductionPtr propose = Rule("propose", {OnState("operator", "<o>")}, {Make({0, Field::kId}, "operator")});
  AddRule(apply);
  AddRule(elaborate);
  AddRule(propose);
  Add("S1", "operator", "O1");
  EXPECT_EQ(rete.production(rete.matches().TakeAssertion(1, kO).production)->name, "apply");
  EXPECT_FALSE(rete.matches().HasAssertions(1, kO));
  EXPECT_EQ(rete.matches().Pending(MatchSet::List::kIAssertions).size(), 2u);
}

TEST_F(ReteTest, AnOperatorOfAHigherGoalGivesISupport) {
  const ProductionPtr rule =
      Rule("deep", {OnState("operator", "<o>"), Positive(Is("<sub>"), Is("superstate"), Is("<s>"))},
           {Make({0, Field::kId}, "done")});
  AddRule(rule);
  Add("S1", "operator", "O1");
  Add("S2", "superstate", "S1");
  EXPECT_TRUE(rete.matches().HasAssertions(2, kI));
  EXPECT_FALSE(rete.matches().HasAssertions(2, kO));
}

TEST_F(ReteTest, MixedElaborationAndApplicationIsReportedAndGetsISupport) {
  const ProductionPtr rule =
      Rule("mixed", {OnState("operator", "<o>")}, {Make({0, Field::kId}, "done"), Make({0, Field::kValue}, "done")});
  int reports = 0;
  rete.OnMixedSupport([&](ProductionId) { ++reports; });
  AddRule(rule);
  Add("S1", "operator", "O1");
  Add("S1", "operator", "O2");
  EXPECT_EQ(reports, 2);
  // The second match is mixed with respect to its own operator. With respect to the older match's operator, it only
  // applies.
  EXPECT_EQ(rete.matches().Pending(MatchSet::List::kIAssertions).size(), 1u);
  EXPECT_EQ(rete.matches().Pending(MatchSet::List::kOAssertions).size(), 1u);
}

TEST_F(ReteTest, AnElaborationOfOneOperatorAppliesThatOfAnOlderMatch) {
  const ProductionPtr rule = Rule("note", {OnState("operator", "<o>")}, {Make({0, Field::kValue}, "noted")});
  AddRule(rule);
  Add("S1", "operator", "O1");
  EXPECT_TRUE(rete.matches().HasAssertions(1, kI));
  Add("S2", "operator", "O2");
  EXPECT_FALSE(rete.matches().HasAssertions(2, kI));
  EXPECT_TRUE(rete.matches().HasAssertions(2, kO));
}

TEST_F(ReteTest, ExcisingARetractsWhatFiredAndForgetsWhatIsPending) {
  const ProductionId rule = AddRule(Rule("a", {OnState("x", "<v>")}));
  Add("S1", "x", "1");
  ASSERT_EQ(FireAll().size(), 1u);
  Add("S1", "x", "2");
  rete.ExciseProduction(rule);
  EXPECT_FALSE(rete.matches().HasAssertions(1, kI));
  const MatchId gone = rete.matches().TakeRetraction(1);
  ASSERT_NE(gone, MatchId::kNone);
  EXPECT_EQ(rete.production(rete.matches().Describe(gone).production)->name, "a");
  const ProductionId other = AddRule(Rule("b", {OnState("x", "<v>")}));
  EXPECT_NE(other, rule) << "the number is in use until the retraction is released";
  rete.matches().Release(gone);
  rete.ExciseProduction(other);
  EXPECT_EQ(rete.statistics().nodes, 1u) << "only the root is left";
  EXPECT_EQ(rete.statistics().tokens, 0u);
  EXPECT_EQ(rete.statistics().alpha_memories, 0u);
}

TEST_F(ReteTest, ANewRulesRefractedMatchIsSilentUntilItGoes) {
  const WmeId wme = Add("S1", "x", "1");
  Add("S1", "x", "2");
  Rete::AddOptions options;
  const std::vector<WmeId> elements = {wme};
  options.refracted = elements;
  options.instantiation = SomeInstantiation(2);
  const Rete::Added added = rete.AddProduction(Rule("chunk", {OnState("x", "<v>")}), Goals(), options);
  ASSERT_NE(added.refracted, MatchId::kNone);
  EXPECT_EQ(FireAll().size(), 1u);
  Remove(wme);
  EXPECT_EQ(rete.matches().InstantiationOf(rete.matches().TakeRetraction(1)), options.instantiation);
}

TEST_F(ReteTest, AFixedMatchRetractsWhenOneOfItsElementsGoes) {
  const WmeId a = Add("S1", "x", "1");
  const WmeId b = Add("S1", "x", "2");
  const MatchId match = rete.AddFixedMatch(std::vector<WmeId>{a, b}, Word("S1"), 1, SomeInstantiation(0));
  EXPECT_FALSE(rete.matches().HasRetractions(1));
  Remove(b);
  EXPECT_EQ(rete.matches().TakeRetraction(1), match);
  EXPECT_FALSE(rete.matches().HasRetractions(1));
  rete.matches().Release(match);
  EXPECT_EQ(rete.statistics().tokens, 0u);
  Remove(a);
}

TEST_F(ReteTest, PartialMatchesOfEachConditionCanBeSeen) {
  const ProductionId rule = AddRule(Rule(
      "r", {OnState("item", "<i>"),
            Conjunction({Positive(Is("<i>"), Is("part"), Is("<p>")), Positive(Is("<p>"), Is("bad"), Is("yes"))})}));
  Add("S1", "item", "A1");
  Add("S1", "item", "B1");
  const WmeId part = Add("A1", "part", "P1");
  using Path = std::vector<std::uint16_t>;
  EXPECT_EQ(rete.CountAfter(rule, Path{0}), 2u);
  EXPECT_EQ(rete.CountAfter(rule, Path{1}), 2u);
  EXPECT_EQ(rete.CountAfter(rule, Path{1, 0}), 1u);
  EXPECT_EQ(rete.CountAfter(rule, Path{1, 1}), 0u);
  EXPECT_THAT(rete.MatchesBefore(rule, Path{1, 1}), ElementsAre(ElementsAre(testing::_, part)));
  EXPECT_THAT(rete.RightMatches(rule, Path{1, 0}), ElementsAre(part));
  Add("P1", "bad", "yes");
  EXPECT_EQ(rete.CountAfter(rule, Path{1}), 1u);
}

TEST_F(ReteTest, AgentsWithEqualRulesShareTheirTopologyUntilOneOfThemChangesIt) {
  MatchFixture other;
  other.SetGoal("S1", 1);
  other.SetGoal("S2", 2);
  AddRule(Rule("a", {OnState("x", "<v>")}));
  other.AddRule(Rule("a", {OnState("x", "<v>")}));
  ASSERT_EQ(rete.NetworkDigest(), other.rete.NetworkDigest());
  ASSERT_TRUE(other.rete.AdoptNetwork(rete.network()));
  EXPECT_EQ(other.rete.network(), rete.network());
  other.Add("S1", "x", "1");
  EXPECT_EQ(other.FireAll().size(), 1u);
  EXPECT_THAT(FireAll(), IsEmpty());
  AddRule(Rule("b", {OnState("y", "<v>")}));
  EXPECT_NE(other.rete.network(), rete.network());
  EXPECT_FALSE(other.rete.AdoptNetwork(rete.network()));
}

TEST_F(ReteTest, LargeMemoriesAreSearchedByIndex) {
  AddRule(Rule("r", {OnState("item", "<i>"), Positive(Is("<i>"), Is("key"), Is("<k>")),
                     Positive(Is("<s>"), Is("wanted"), Is("<k>"))}));
  for (int n = 0; n < 3000; ++n) {
    const std::string id = "I" + std::to_string(n + 1);
    Add("S1", "item", id);
    Add(id, "key", std::to_string(n));
  }
  const WmeId wanted = Add("S1", "wanted", "77");
  EXPECT_EQ(FireAll().size(), 1u);
  Remove(wanted);
  Add("S1", "wanted", "78");
  EXPECT_EQ(FireAll().size(), 1u);
  while (!live.empty()) {
    Remove(live.front());
  }
  EXPECT_EQ(rete.statistics().tokens, 1u) << "the root's own token";
  EXPECT_EQ(rete.CheckInvariants(), "");
}

}  // namespace
}  // namespace soarbox::kernel
