// SPDX-License-Identifier: BSD-2-Clause
#include "explain/command_inspector.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace soarbox::explain {
namespace {

/// The output of Soar 9.6.3 for the `time`-th occurrence of a command in a golden case.
std::string Answer(const std::string& file, const std::string& command, int time = 1) {
  std::ifstream in(std::string(SOARBOX_SOURCE_DIR) + "/tests/golden/" + file);
  std::ostringstream text;
  text << in.rdbuf();
  const std::string all = text.str(), mark = "% " + command + "\n";
  std::size_t at = 0;
  for (int i = 0; i < time; ++i) at = all.find(mark, at) + mark.size();
  EXPECT_GE(at, mark.size()) << "there is no " << command << " in " << file;
  return all.substr(at, all.find("\n% ", at) - at);
}

TEST(CommandInspector, ReadsMatches) {
  const std::string file = "core/matches-command/expected.out";
  const MatchFacts none = ReadMatches("mt*large", Answer(file, "matches mt*large"));
  ASSERT_EQ(none.conditions.size(), 3u);
  EXPECT_EQ(none.failing, 0u);
  EXPECT_EQ(none.complete, 0u);
  EXPECT_EQ(none.conditions[0].text, "(state <s> ^item <i>)");
  EXPECT_TRUE(none.conditions[1].negated);
  const MatchFacts one = ReadMatches("mt*large", Answer(file, "matches mt*large", 2));
  EXPECT_FALSE(one.failing.has_value());
  EXPECT_EQ(one.conditions[0].partial_matches, 2u);
  EXPECT_EQ(one.complete, 1u);
}

TEST(CommandInspector, TakesAConjunctiveNegationAsOneCondition) {
  const MatchFacts facts = ReadMatches("r",
                                       "   1 (state <s> ^a <a>)\n"
                                       "    -{\n"
                                       "        1 (<s> ^b <b>)\n"
                                       "     >>>> (<b> ^c <c>)\n"
                                       ">>>> }\n"
                                       "     (<s> ^d <d>)\n\n0 complete matches.\n");
  ASSERT_EQ(facts.conditions.size(), 3u);
  EXPECT_EQ(facts.failing, 1u);
  EXPECT_EQ(facts.conditions[1].text, "-{ (<s> ^b <b>) (<b> ^c <c>) }");
  EXPECT_TRUE(facts.conditions[1].negated);
}

TEST(CommandInspector, ReadsTheStack) {
  const std::vector<StateFact> stack = ReadStack(Answer("random/007/expected.out", "print -s"));
  ASSERT_EQ(stack.size(), 2u);
  EXPECT_EQ(stack[0].id, "S1");
  EXPECT_EQ(stack[0].impasse, "none");
  EXPECT_EQ(stack[1].id, "S5");
  EXPECT_EQ(stack[1].attribute, "state");
  EXPECT_EQ(stack[1].impasse, "no-change");
  EXPECT_EQ(stack[1].operator_name, "res-no-change");
}

TEST(CommandInspector, ReadsPreferences) {
  const OperatorFacts facts = ReadPreferences(Answer("random/009/expected.out", "preferences s1 operator --names"));
  ASSERT_GE(facts.preferences.size(), 3u);
  EXPECT_EQ(facts.preferences[0].type, "acceptable");
  EXPECT_EQ(facts.preferences[0].value, "O60");
  EXPECT_EQ(facts.preferences[0].name, "opa");
  EXPECT_EQ(facts.preferences[0].maker.rule, "prop*opa");
  EXPECT_FALSE(facts.preferences[0].maker.o_supported);
  EXPECT_EQ(facts.preferences[2].type, "indifferent");
  const OperatorFacts one = ReadPreferences(Answer("random/017/expected.out", "preferences s1 operator --names"));
  ASSERT_EQ(one.candidates.size(), 1u);
  EXPECT_EQ(one.candidates[0].id, "O11");
  EXPECT_EQ(one.candidates[0].probability, 1);
}

TEST(CommandInspector, ReadsElementsAndSkipsTheRest) {
  const std::vector<ElementFact> elements =
      ReadElements("(12: S1 ^|a b| |x)| )\n(3: I2 ^operator O1 +)\n(S1 ^a b) text (x: y) (4: S1 a b) (");
  ASSERT_EQ(elements.size(), 2u);
  EXPECT_EQ(elements[0], (ElementFact{12, "S1", "|a b|", "|x)|", false, false}));
  EXPECT_EQ(elements[1], (ElementFact{3, "I2", "operator", "O1", true, true}));
}

}  // namespace
}  // namespace soarbox::explain
