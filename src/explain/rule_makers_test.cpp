// SPDX-License-Identifier: BSD-2-Clause
#include "explain/rule_makers.h"

#include <gtest/gtest.h>

namespace soarbox::explain {
namespace {

RuleText OneRule(const std::string& conditions, const std::string& actions) {
  std::vector<RuleText> rules = ReadRules("sp {r\n    " + conditions + "\n    -->\n    " + actions + "\n}\n");
  EXPECT_EQ(rules.size(), 1u);
  return rules.empty() ? RuleText() : rules.front();
}

/// Returns whether a rule with these conditions and actions creates what the condition `asked` requires. `waits` are
/// the other conditions of the waiting rule.
Makes Unify(const std::string& waits, const std::string& asked, const std::string& conditions,
            const std::string& actions) {
  const RuleText rule = OneRule(waits + " " + asked, "(<s> ^done yes)");
  const std::vector<ConditionText> condition = ReadCondition(rule, asked);
  EXPECT_EQ(condition.size(), 1u);
  return WhetherMakes(OneRule(conditions, actions), rule, condition.front());
}

TEST(RuleMakers, UnifyTheValue) {
  const auto with = [](const std::string& asked, const std::string& made) {
    return Unify("(state <s> ^superstate nil)", "(<s> ^mood " + asked + ")", "(state <s> ^superstate nil ^x <x>)",
                 "(<s> ^mood " + made + " +)");
  };
  EXPECT_EQ(with("calm", "calm"), Makes::kYes);
  EXPECT_EQ(with("calm", "wild"), Makes::kNo);
  EXPECT_EQ(with("<m>", "wild"), Makes::kYes);
  EXPECT_EQ(with("<> calm", "calm"), Makes::kNo);
  EXPECT_EQ(with("<> calm", "wild"), Makes::kYes);
  EXPECT_EQ(with("<< calm glad >>", "wild"), Makes::kNo);
  EXPECT_EQ(with("<< calm glad >>", "glad"), Makes::kYes);
  EXPECT_EQ(with("{ > 5 < 10 <m> }", "7"), Makes::kYes);
  EXPECT_EQ(with("{ > 5 < 10 <m> }", "12"), Makes::kNo);
  EXPECT_EQ(with("> 5", "many"), Makes::kNo);
  EXPECT_EQ(with("calm", "<x>"), Makes::kMaybe);
  EXPECT_EQ(with("<> calm", "<x>"), Makes::kMaybe);
  EXPECT_EQ(with("<m>", "<x>"), Makes::kYes);
  EXPECT_EQ(with("> 5", "(+ <x> 1)"), Makes::kMaybe);
}

TEST(RuleMakers, UnifyTheAttributeAndThePlace) {
  const std::string top = "(state <s> ^superstate nil)";
  EXPECT_EQ(Unify(top, "(<s> ^danger yes)", top, "(<s> ^dangers yes +)"), Makes::kNo);
  EXPECT_EQ(Unify(top, "(<s> ^danger yes)", top, "(<s> ^note <n> +) (<n> ^danger yes +)"), Makes::kNo);
  EXPECT_EQ(Unify(top, "(<s> ^danger yes)", "(state <s> ^superstate nil ^a <a>)", "(<s> ^<a> yes +)"), Makes::kMaybe);
  EXPECT_EQ(Unify(top, "(<s> ^danger yes)", top, "(<s> ^danger yes -)"), Makes::kNo);
  const std::string plan = "(state <s> ^superstate nil ^plan <p>)";
  EXPECT_EQ(Unify(plan, "(<p> ^step go)", plan, "(<p> ^step go +)"), Makes::kYes);
  EXPECT_EQ(Unify(plan, "(<p> ^step go)", top, "(<s> ^plan <q> +) (<q> ^step go +)"), Makes::kYes);
  // An element at another path satisfies the condition only if both paths lead to the same object.
  EXPECT_EQ(Unify(plan, "(<p> ^step go)", top, "(<s> ^note <q> +) (<q> ^step go +)"), Makes::kElsewhere);
  EXPECT_EQ(Unify(plan, "(<p> ^step go)", top, "(<s> ^step go +)"), Makes::kNo);
}

TEST(RuleMakers, UnifyTheKindOfValue) {
  const std::string top = "(state <s> ^superstate nil)";
  const std::string below = "(state <s> ^superstate nil) (<p> ^step go)";
  EXPECT_EQ(Unify(below, "(<s> ^plan <p>)", top, "(<s> ^plan none +)"), Makes::kNo);
  EXPECT_EQ(Unify(below, "(<s> ^plan <p>)", top, "(<s> ^plan <q> +) (<q> ^step go +)"), Makes::kYes);
  EXPECT_EQ(Unify(top, "(<s> ^plan none)", top, "(<s> ^plan <q> +) (<q> ^step go +)"), Makes::kNo);
}

TEST(RuleMakers, UnifyTheState) {
  const std::string top = "(state <s> ^superstate nil)", sub = "(state <s> ^superstate <ss>)";
  EXPECT_EQ(Unify(top, "(<s> ^danger yes)", sub, "(<s> ^danger yes +)"), Makes::kNo);
  EXPECT_EQ(Unify(top, "(<s> ^danger yes)", sub, "(<ss> ^danger yes +)"), Makes::kYes);
  EXPECT_EQ(Unify(sub, "(<ss> ^danger yes)", top, "(<s> ^danger yes +)"), Makes::kYes);
  EXPECT_EQ(Unify(top, "(<s> ^danger yes)", "(state <s> ^ready yes)", "(<s> ^danger yes +)"), Makes::kYes);
}

TEST(RuleMakers, AProposalIsOfAName) {
  const std::string prefers = "(state <s> ^superstate nil) (<o> ^name seek)", top = "(state <s> ^superstate nil)";
  EXPECT_EQ(Unify(prefers, "(<s> ^operator <o> +)", top, "(<s> ^operator <q> +) (<q> ^name seek +)"), Makes::kYes);
  EXPECT_EQ(Unify(prefers, "(<s> ^operator <o> +)", top, "(<s> ^operator <q> +) (<q> ^name rest +)"), Makes::kNo);
  // Rules propose operators; only the decision procedure selects them.
  EXPECT_EQ(Unify(prefers, "(<s> ^operator <o>)", top, "(<s> ^operator <q> +) (<q> ^name seek +)"), Makes::kNo);
}

TEST(RuleMakers, WhatARuleDoesToAnOperatorAloneDoesNotApplyIt) {
  const std::string selected = "(state <s> ^operator <o>) (<o> ^name go)";
  EXPECT_FALSE(Changes(OneRule(selected, "(<o> ^speed 3 +)")));
  EXPECT_FALSE(Changes(OneRule(selected, "(write |going|)")));
  EXPECT_TRUE(Changes(OneRule(selected, "(<s> ^gone yes +)")));
  EXPECT_TRUE(Changes(OneRule(selected, "(halt)")));
  // Nor do elements that it adds to the substate of the operator's impasse.
  const std::string below = "(state <s> ^superstate <ss>) (<ss> ^operator <o>) (<o> ^name go)";
  EXPECT_FALSE(Changes(OneRule(below, "(<s> ^name go +)")));
  EXPECT_FALSE(Changes(OneRule(below, "(<s> ^plan <p> +) (<p> ^step 1 +)")));
  EXPECT_TRUE(Changes(OneRule(below, "(<ss> ^gone yes +)")));
}

}  // namespace
}  // namespace soarbox::explain
