// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/rule_gaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/rules/parser.h"

namespace soarbox::kernel {
namespace {

using testing::HasSubstr;

class RuleGapsTest : public testing::Test {
 protected:
  /// Adds a proposal with a test on ^distance.
  void Propose(const std::string& name, const std::string& test, const std::string& variable = "<e>") {
    Add(name + " (state <s> ^enemy " + variable + ") (" + variable + " ^distance " + test +
        ") --> (<s> ^operator <o> +) (<o> ^name " + name + ")");
  }
  void Add(const std::string& body) {
    const ProductionPtr rule = ParseProduction(body, {"scout.soar", ++line_ * 10, 5}, symbols_).production;
    ASSERT_NE(rule, nullptr) << body;
    kept_.push_back(rule);
    rules_.push_back(rule.get());
  }
  std::vector<Diagnostic> Gaps(std::size_t fresh = 1000) { return FindRuleGaps(rules_, fresh, symbols_); }

  SymbolTable symbols_;
  std::vector<ProductionPtr> kept_;
  std::vector<const Production*> rules_;
  int line_ = 0;
};

TEST_F(RuleGapsTest, ANumberBetweenTwoProposalsIsToldOfAtTheLaterOne) {
  Propose("flee", "< 3");
  Propose("seek", "> 3", "<foe>");
  const std::vector<Diagnostic> gaps = Gaps();
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_EQ(gaps[0].severity, Severity::kWarning);
  EXPECT_EQ(gaps[0].file, "scout.soar");
  EXPECT_EQ(gaps[0].line, 20);
  EXPECT_EQ(gaps[0].column, 5);
  EXPECT_EQ(gaps[0].message, "if ^distance is exactly 3, neither flee (< 3) nor seek (> 3) proposes");
  EXPECT_THAT(gaps[0].hint, HasSubstr("<="));
}

TEST_F(RuleGapsTest, RangesThatMeetAreFollowedUpwards) {
  Propose("near", "{ <d> < 3 }");
  Propose("middle", "{ <d> > 3 <= 9 }");
  Propose("far", "{ <d> > 9.0 }");
  EXPECT_EQ(Gaps().size(), 1u) << "9 is taken by the middle one";
}

TEST_F(RuleGapsTest, ANumberThatAnyProposalTakesIsNoGap) {
  Propose("flee", "< 3");
  Propose("seek", ">= 3");
  Propose("far", "> 7");
  Propose("near", "< 7");
  EXPECT_TRUE(Gaps().empty()) << "7 is taken by seek";
  Propose("low", "< 1.5");
  EXPECT_TRUE(Gaps().empty());
}

TEST_F(RuleGapsTest, ARuleThatNamesTheNumberFillsTheGap) {
  Propose("flee", "< 3");
  Propose("seek", "> 3");
  ASSERT_EQ(Gaps().size(), 1u);
  Propose("wait", "3");
  EXPECT_TRUE(Gaps().empty());
}

TEST_F(RuleGapsTest, AProposalForAnyDistanceFillsTheGap) {
  Propose("flee", "< 3");
  Propose("seek", "> 3");
  Propose("look", "<d>");
  EXPECT_TRUE(Gaps().empty());
}

TEST_F(RuleGapsTest, OnlySiblingsThatProposeCount) {
  Propose("flee", "< 3");
  Add("other (state <s> ^friend <e>) (<e> ^distance > 3) --> (<s> ^operator <o> +) (<o> ^name other)");
  Add("note (state <s> ^enemy <e>) (<e> ^distance > 3) --> (<s> ^far yes)");
  Propose("wide", "> 4");
  EXPECT_TRUE(Gaps().empty()) << "a range that nobody takes is often meant";
}

TEST_F(RuleGapsTest, OldGapsAreNotToldOfAgain) {
  Propose("flee", "< 3");
  Propose("seek", "> 3");
  Propose("far", "> 30");
  EXPECT_TRUE(Gaps(1).empty());
  EXPECT_EQ(Gaps(2).size(), 1u);
}

}  // namespace
}  // namespace soarbox::kernel
