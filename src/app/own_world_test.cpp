// SPDX-License-Identifier: BSD-2-Clause
#include "app/own_world.h"

#include <gtest/gtest.h>

namespace soarbox::app {
namespace {

const std::string kText = R"(# sp {in*a*comment
smem --enable
sp {one
   (state <s> ^{ << a b >> <x> } |a } in bars| ^c |#|)   # }
-->
   (<s> ^d |{|)}
alias x print
sp {two (state <s> ^e)
-->
   (<s> ^f)
}
)";

TEST(OwnWorld, RulesAreFoundByNameAndLeftOutAlone) {
  EXPECT_EQ(RuleNamesIn(kText), (std::vector<std::string>{"one", "two"}));
  const std::string without = WithoutRule(kText, "one");
  EXPECT_EQ(RuleNamesIn(without), std::vector<std::string>{"two"});
  EXPECT_NE(without.find("smem --enable\n\nalias x print"), std::string::npos) << without;
  EXPECT_EQ(WithoutRule(kText, "three"), kText);
}

TEST(OwnWorld, ATextThatEndsWithinARuleIsNoTrouble) {
  EXPECT_EQ(RuleNamesIn("sp {one\n (state"), std::vector<std::string>{"one"});
  EXPECT_EQ(WithoutRule("sp {one\n (state", "one"), "");
  EXPECT_TRUE(RuleNamesIn("sp").empty());
  EXPECT_TRUE(RuleNamesIn("sp {").empty());
}

}  // namespace
}  // namespace soarbox::app
