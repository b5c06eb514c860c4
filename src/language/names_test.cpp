// SPDX-License-Identifier: BSD-2-Clause
#include "language/names.h"

#include <gtest/gtest.h>

namespace soarbox::language {
namespace {

Word WordOf(const std::string& rule, std::string_view text, std::size_t nth = 0) {
  for (const Word& word : ReadWords(rule).words)
    if (word.text == text && nth-- == 0) return word;
  return {};
}

TEST(ReadWords, PathsLeadFromTheStateToTheObject) {
  const std::string rule =
      "sp {a (state <s> ^io.input-link <in> ^superstate.operator <o>) (<in> ^agent.position <p>) (<p> ^x 3)"
      " (<o> ^name go) --> (<s> ^seen <p>)}";
  EXPECT_EQ(WordOf(rule, "x").path, "io.input-link.agent.position.x");
  EXPECT_EQ(WordOf(rule, "3").path, "io.input-link.agent.position.x");
  EXPECT_EQ(WordOf(rule, "go").path, "superstate.operator.name");
  EXPECT_TRUE(IsOperatorName(WordOf(rule, "go")));
  EXPECT_EQ(WordOf(rule, "seen").path, "seen");
  EXPECT_TRUE(WordOf(rule, "seen").in_actions);
}

TEST(ReadWords, ObjectsThatNoStateLeadsToAreNamedByTheirVariable) {
  EXPECT_EQ(WordOf("sp {a (<x> ^color red) -->}", "color").path, "<x>.color");
}

TEST(ReadWords, CirclesOfVariablesEnd) {
  EXPECT_EQ(WordOf("sp {a (state <s> ^n <a>) (<a> ^n <b>) (<b> ^n <a> ^m 1) -->}", "m").path, "n.n.m");
}

TEST(ReadWords, AnArrowEndsAnOpenClause) {
  const RuleWords rule = ReadWords("sp {a (state <s> ( --> <o> ^x y)}");
  EXPECT_EQ(rule.heads.size(), 1u) << "only <s>";
}

TEST(ReadWords, AnyTextGivesWords) {
  for (const char* text :
       {"", "sp {", "sp {a (", "sp {a (state", "sp {a (state <s> ^", "sp {a (state <s> ^a.", "^^..^<", "((^a|"})
    EXPECT_NO_FATAL_FAILURE(ReadWords(text)) << text;
}

class Names : public testing::Test {
 protected:
  void Open(const std::string& text) {
    workspace_.Open("/rules.soar", text);
    program_.documents = {workspace_.Find("/rules.soar")};
  }
  std::string Renamed(std::string_view word, const std::string& to) {
    const Document& document = *program_.documents.front();
    const Result<Renaming> renaming = Rename(program_, document, document.text().find(word), to);
    if (!renaming) return "refused: " + renaming.error().message;
    std::string text = document.text();
    for (auto use = renaming->uses.rbegin(); use != renaming->uses.rend(); ++use)
      text.replace(use->span.begin, use->span.end - use->span.begin, renaming->text);
    return text;
  }
  Workspace workspace_;
  Program program_;
};

TEST_F(Names, BarsStayAroundARenamedName) {
  Open("sp {a (state <s> ^operator <o>) (<o> ^name |go|) --> (<s> ^x y)}");
  EXPECT_EQ(Renamed("go|", "run"), "sp {a (state <s> ^operator <o>) (<o> ^name |run|) --> (<s> ^x y)}");
}

TEST_F(Names, TheWorldsWordStaysWhereTheSameWordIsTheAgentsOwn) {
  Open("sp {a (state <s> ^io.input-link.self.speed <v>) --> (<s> ^speed <v>)}");
  EXPECT_EQ(Renamed("speed <v>)}", "pace"), "sp {a (state <s> ^io.input-link.self.speed <v>) --> (<s> ^pace <v>)}");
  EXPECT_EQ(Renamed("speed <v>) -->", "pace"), "refused: ^speed is a percept: the world gives it its name");
}

TEST_F(Names, VariablesAreThoseOfTheirRule) {
  Open("sp {a (state <s> ^b c) --> (<s> ^d e)}\nsp {f (state <s> ^b c) --> (<s> ^d e)}");
  EXPECT_EQ(Renamed("<s>", "t"), "sp {a (state <t> ^b c) --> (<t> ^d e)}\nsp {f (state <s> ^b c) --> (<s> ^d e)}");
}

}  // namespace
}  // namespace soarbox::language
