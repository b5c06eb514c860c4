// SPDX-License-Identifier: BSD-2-Clause
#include "explain/rule_text.h"

#include <gtest/gtest.h>

namespace soarbox::explain {
namespace {

constexpr const char* kPrinted =
    "sp {a*propose\n    (state <s> ^superstate nil ^io <i*1> -^done)\n    (<i*1> ^input-link <in>)\n"
    "    -{\n      (<in> ^agent <a>)\n      (<a> ^range < 3)\n    }\n    -->\n"
    "    (<s> ^operator <o> + =)\n    (<o> ^name go)\n}\n\n"
    "sp {a*apply\n    (state <s> ^operator <o> ^io <i*1>)\n    (<o> ^name << go stay >>)\n    (<i*1> ^output-link "
    "<out>)\n"
    "    -->\n    (<out> ^move-to <c> + ^stop <d> -)\n    (<c> ^x (+ 1 2) +)\n}\n";

TEST(RuleText, TellsWhatARuleProposesAppliesAndSays) {
  const std::vector<RuleText> rules = ReadRules(kPrinted);
  ASSERT_EQ(rules.size(), 2u);
  EXPECT_EQ(rules[0].name, "a*propose");
  EXPECT_EQ(rules[0].proposes, std::set<std::string>{"go"});
  EXPECT_EQ(rules[1].applies, (std::set<std::string>{"go", "stay"}));
  EXPECT_EQ(rules[1].says, std::set<std::string>{"move-to"});
}

TEST(RuleText, KnowsWhichConditionsAreNegated) {
  const std::vector<RuleText> rules = ReadRules(kPrinted);
  for (const RuleAttribute& condition : rules[0].conditions) {
    const bool negated =
        condition.attribute == "done" || condition.attribute == "agent" || condition.attribute == "range";
    EXPECT_EQ(condition.negated, negated) << condition.attribute;
  }
}

TEST(RuleText, CommentsAreBlankedAndPlacesStay) {
  EXPECT_EQ(BlankComments("ab # c\n|# no| # x"), "ab    \n|# no|    ");
}

}  // namespace
}  // namespace soarbox::explain
