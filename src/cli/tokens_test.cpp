// SPDX-License-Identifier: BSD-2-Clause
#include "cli/tokens.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace soarbox::cli {
namespace {

using testing::ElementsAre;

std::vector<std::string> Texts(const std::vector<Word>& words) {
  std::vector<std::string> texts;
  for (const Word& word : words) texts.push_back(word.text);
  return texts;
}

std::vector<std::vector<std::string>> Commands(std::string_view text) {
  CommandReader reader(text);
  std::vector<std::vector<std::string>> commands;
  std::vector<Word> words;
  while (reader.Next(words) == CommandReader::Status::kCommand) commands.push_back(Texts(words));
  return commands;
}

TEST(CommandReader, SplitsCommandsAtNewlinesAndSemicolons) {
  EXPECT_THAT(Commands("echo a;;echo  b\n\nrun 1"),
              ElementsAre(ElementsAre("echo", "a"), ElementsAre("echo", "b"), ElementsAre("run", "1")));
}

TEST(CommandReader, BracesNestAndBarsInsideThemAreLiteral) {
  EXPECT_THAT(Commands("sp {a {b} |}#| c}"), ElementsAre(ElementsAre("sp", "a {b} |}#| c")));
}

TEST(CommandReader, ACommentInsideBracesEndsWithItsLine) {
  EXPECT_THAT(Commands("sp {a # }\nb}"), ElementsAre(ElementsAre("sp", "a \nb")));
}

TEST(CommandReader, AWordThatBeginsAfterAClosingBraceOrQuoteIsItsOwn) {
  EXPECT_THAT(Commands(R"({a}b "c"d a{b}c a"b")"), ElementsAre(ElementsAre("a", "b", "c", "d", "a{b}c", "a\"b\"")));
}

TEST(CommandReader, BackslashesEscapeOutsideBracesOnly) {
  EXPECT_THAT(Commands(R"(a\ b "x\ty\q" {a\ b \} c})"), ElementsAre(ElementsAre("a b", "x\tyq", R"(a\ b \} c)")));
}

TEST(CommandReader, TextBetweenBarsIsLiteralInBareWordsToo) {
  EXPECT_THAT(Commands("print |a; b| c|#  d|"), ElementsAre(ElementsAre("print", "|a; b|", "c|")));
  CommandReader reader("echo |open");
  std::vector<Word> words;
  EXPECT_EQ(reader.Next(words), CommandReader::Status::kError);
}

TEST(CommandReader, AJoinedLineIsOneCommand) {
  EXPECT_THAT(Commands("run \\\n  1"), ElementsAre(ElementsAre("run", "1")));
}

TEST(CommandReader, WordsKnowWhereTheyBegin) {
  CommandReader reader("\n  sp {a\nb}");
  std::vector<Word> words;
  ASSERT_EQ(reader.Next(words), CommandReader::Status::kCommand);
  EXPECT_EQ(words[1].line, 2);
  EXPECT_EQ(words[1].column, 7);
}

TEST(CommandReader, AnUnmatchedBraceIsNamedByItsPlaceAndTheNextCommandIsStillRead) {
  CommandReader reader("echo a\nsp {b (c)\n   d\nsp {e}\n");
  std::vector<Word> words;
  ASSERT_EQ(reader.Next(words), CommandReader::Status::kCommand);
  ASSERT_EQ(reader.Next(words), CommandReader::Status::kError);
  EXPECT_EQ(reader.error(), "unexpected eof, unmatched opening brace");
  EXPECT_EQ(reader.error_line(), 2);
  EXPECT_EQ(reader.error_column(), 4);
  reader.Recover();
  ASSERT_EQ(reader.Next(words), CommandReader::Status::kCommand);
  EXPECT_THAT(Texts(words), ElementsAre("sp", "e"));
}

TEST(QuoteWord, IsReadBackAsOneWord) {
  for (const std::string text : {"plain", "two words", "a;b", "quo\"te", "back\\slash", "", "{x", "a#b", "b|r"}) {
    const std::string quoted = QuoteWord(text);
    CommandReader reader(quoted);
    std::vector<Word> words;
    ASSERT_EQ(reader.Next(words), CommandReader::Status::kCommand) << text;
    EXPECT_THAT(Texts(words), ElementsAre(text));
  }
}

}  // namespace
}  // namespace soarbox::cli
