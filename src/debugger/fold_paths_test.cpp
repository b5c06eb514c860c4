// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/fold_paths.h"

#include <gmock/gmock.h>

namespace soarbox::debugger {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> Texts(const explain::MatchFacts& facts) {
  std::vector<std::string> texts;
  for (const explain::ConditionFact& condition : facts.conditions) texts.push_back(condition.text);
  return texts;
}

explain::MatchFacts PathFacts(const std::vector<std::string>& texts, std::optional<std::size_t> failing) {
  explain::MatchFacts facts;
  for (const std::string& text : texts) facts.conditions.push_back({text, text.front() == '-', 1});
  facts.failing = failing;
  return facts;
}

TEST(FoldedPaths, AreThoseThatTheAuthorWrote) {
  const explain::MatchFacts folded =
      FoldPaths(PathFacts({"(state <s> ^superstate nil)", "(<s> ^io <i*1>)", "(<i*1> ^input-link <i*2>)",
                           "(<i*2> ^self <s*1>)", "(<s*1> ^health { < 10 <h*1> })"},
                          4));
  EXPECT_THAT(Texts(folded), ElementsAre("(state <s> ^superstate nil)", "(<s> ^io.input-link.self.health < 10)"));
  EXPECT_EQ(folded.failing, 1U);
}

TEST(FoldedPaths, EndWhereTheRuleStops) {
  const explain::MatchFacts folded = FoldPaths(
      PathFacts({"(<s> ^io <i*1>)", "(<i*1> ^input-link <i*2>)", "(<i*2> ^enemy <e*1>)", "(<e*1> ^name <n>)"}, 2));
  EXPECT_THAT(Texts(folded), ElementsAre("(<s> ^io.input-link.enemy)", "(<s> ^io.input-link.enemy.name <n>)"));
  EXPECT_EQ(folded.failing, 0U);
}

TEST(FoldedPaths, LeaveAllElseAsItIs) {
  const std::vector<std::string> texts{"(<s> ^operator <o> +)", "-(<s> ^told <name>)", "(<o> ^name << eat drink >>)",
                                       "(<o> ^range { > 2 < 6 })", "-{(<s> ^a <b>)(<b> ^c d)}"};
  EXPECT_EQ(Texts(FoldPaths(PathFacts(texts, 2))), texts);
  EXPECT_EQ(FoldPaths(PathFacts(texts, 2)).failing, 2U);
  EXPECT_FALSE(FoldPaths(PathFacts(texts, std::nullopt)).failing);
}

TEST(FoldedPaths, KeepANegatedEnd) {
  EXPECT_THAT(Texts(FoldPaths(PathFacts({"(<s> ^io <i*1>)", "-(<i*1> ^input-link <i*2>)"}, 1))),
              ElementsAre("-(<s> ^io.input-link)"));
}

}  // namespace
}  // namespace soarbox::debugger
