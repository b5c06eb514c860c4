// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/plain_text.h"

#include <gtest/gtest.h>

#include "diagnostics/diagnostic.h"

namespace soarbox {
namespace {

TEST(PlainText, ShowsControlCharactersAndLeavesLettersOfAllLanguages) {
  EXPECT_EQ(Printable("\x1B[31mred\a\tnaïve \x7F"), "\\x1b[31mred\\x07\tnaïve \\x7f");
  EXPECT_EQ(Printable("a\xC2\x9B\x32Jb"), "a\\x9b2Jb");
  EXPECT_EQ(Printable("a\nb", nullptr), "a\\nb");
}

TEST(PlainText, IsCutBetweenLettersAndTellsHowMuchIsLeftOut) {
  EXPECT_EQ(Printable("aäb", "", 2), "a ... (3 more bytes)");
  EXPECT_EQ(Printable("abc", "", 3), "abc");
  EXPECT_EQ(Beginning("aäb", 2), "a");
  EXPECT_EQ(Beginning("aäb", 3), "aä");
  EXPECT_EQ(Beginning("ä", 1), "");
  EXPECT_EQ(Beginning("ä", 9), "ä");
}

TEST(PlainText, NoForeignTextPassesForAMessageOfItsOwn) {
  Diagnostic problem;
  problem.file = "a.lua";
  problem.line = 3;
  problem.message = "\x1B[2Jlost\nb.lua:1: error: you lost";
  EXPECT_EQ(Format(problem), "a.lua:3: error: \\x1b[2Jlost\n   b.lua:1: error: you lost\n");
}

TEST(PlainText, ALongLineIsShownAroundItsPlace) {
  Diagnostic problem;
  problem.message = "here";
  problem.excerpt = std::string(1000, 'a') + "HERE" + std::string(1000, 'b');
  problem.column = 1001;
  problem.excerpt_length = 4;
  const std::string text = Format(problem);
  EXPECT_LT(text.size(), 500u);
  const std::size_t line = text.find('\n') + 1, caret = text.find('\n', line) + 1;
  EXPECT_EQ(text.find("HERE") - line, text.find("^~~~") - caret) << text;
}

TEST(PlainText, OtherEncodingsAndBinaryFilesAreRecognised) {
  EXPECT_EQ(WhyNoPlainText("sp {a}"), "");
  EXPECT_EQ(WhyNoPlainText(std::string("\xFF\xFEs\0p\0", 6)), "this file is UTF-16: save it as UTF-8");
  EXPECT_EQ(WhyNoPlainText(std::string("a\nb\0", 4)), "this is not a text file: line 2 holds a zero byte");
  EXPECT_EQ(WithoutByteOrderMark("\xEF\xBB\xBFsp"), "sp");
}

}  // namespace
}  // namespace soarbox
