// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/lexer.h"

#include <gtest/gtest.h>

#include <vector>

namespace soarbox::kernel {
namespace {

/// `text` must outlive the tokens. Texts that the lexer creates are never freed.
std::vector<RuleToken> Tokens(std::string_view text) {
  static Arena arena;
  Lexer lexer(text, arena);
  std::vector<RuleToken> tokens;
  for (RuleToken token = lexer.Next(); token.kind != TokenKind::kEnd; token = lexer.Next()) {
    tokens.push_back(token);
  }
  return tokens;
}

/// Kinds as letters: s string, i integer, f float, v variable, I identifier, q quoted, '.' path dot, '@' and so on.
std::string Shape(std::string_view text) {
  std::string out;
  for (const RuleToken& token : Tokens(text)) {
    switch (token.kind) {
      case TokenKind::kString:
        out += 's';
        break;
      case TokenKind::kInteger:
        out += 'i';
        break;
      case TokenKind::kFloat:
        out += 'f';
        break;
      case TokenKind::kVariable:
        out += 'v';
        break;
      case TokenKind::kIdentifier:
        out += 'I';
        break;
      case TokenKind::kQuoted:
        out += 'q';
        break;
      case TokenKind::kUnclosed:
        out += 'u';
        break;
      default:
        out.append("[").append(token.text).append("]");
        break;
    }
  }
  return out;
}

TEST(Lexer, TellsNumbersFromStringsAsSoarDoes) {
  EXPECT_EQ(Shape("1 -1 +1 01 -0"), "iiiii");
  EXPECT_EQ(Shape("1.0 .5 -.5 5. 1.5e3 1.5E-3 1.5e+3 +5.5 -. 5.e 1.5e+"), "fffffffffff");
  EXPECT_EQ(Shape("1e3 0x10 1_000 1-2 -5a +1+ 5a --5"), "ssssssss");
  EXPECT_EQ(Shape("5.5.5"), "ff");
  EXPECT_EQ(Tokens("1.5E-3")[0].real, 0.0015);
  EXPECT_EQ(Tokens("-9223372036854775808")[0].integer, INT64_MIN);
}

TEST(Lexer, ADotAfterANameIsAPathDotAndAfterABlankStartsAFloat) {
  EXPECT_EQ(Shape("a.b"), "s[.]s");
  EXPECT_EQ(Shape("a.5"), "s[.]i");
  EXPECT_EQ(Shape("<x>.5.6"), "v[.]f");
  EXPECT_EQ(Shape("a .5"), "sf");
  EXPECT_EQ(Shape("a .5a"), "s[.]s");
  EXPECT_EQ(Shape("1.5ex"), "i[.]s");
  EXPECT_EQ(Shape("|a b|.|c|"), "s[.]s");
}

TEST(Lexer, KnowsVariablesIdentifiersAndSigns) {
  EXPECT_EQ(Shape("<s> <<x>> <=x> <s*-$%&+=:?_/>"), "vvvv");
  EXPECT_EQ(Shape("s1 R22 s01 S1a"), "IIIs");
  EXPECT_EQ(Tokens("s01")[0].text, "S1");
  EXPECT_EQ(Shape("<= <> <=> << >> --> > < ="), "[<=][<>][<=>][<<][>>][-->][>][<][=]");
  EXPECT_EQ(Shape("-^a --^a --> --->"), "[-][^]ss[^]s[-->]s");
  EXPECT_EQ(Shape("@+ @- @+b @5 !@"), "[@+][@-][@]s[@]i[!][@]");
}

TEST(Lexer, WarnsOfStringsThatLookLikeVariables) {
  for (const char* text : {"<s", "s>", "<5", "->", "=>", "<>a", "a>>"}) {
    EXPECT_EQ(Tokens(text)[0].Warning(), "Warning: Suspicious string constant \"" + std::string(text) + "\"\n");
  }
  for (const char* text : {">5", ">=5", "-abc", "-->x", ">>x"}) {
    EXPECT_EQ(Tokens(text)[0].Warning(), "") << text;
  }
}

TEST(Lexer, BarsTakeEverythingAndBackslashTheNextCharacter) {
  EXPECT_EQ(Tokens("|one\\|two|")[0].text, "one|two");
  EXPECT_EQ(Tokens("|a\\\\b|")[0].text, "a\\b");
  EXPECT_EQ(Tokens("||")[0].text, "");
  EXPECT_EQ(Shape("|a|b a|b|"), "ssss");
  EXPECT_EQ(Shape("a |open"), "su");
  EXPECT_EQ(Shape("\"open"), "u");
}

TEST(Lexer, CommentsSemicolonsAndForeignCharactersAreBlanks) {
  EXPECT_EQ(Shape("a # b c\nd;e\xC3\xA9"
                  "f[g]'h"),
            "ssssss");
  EXPECT_EQ(Shape("|# no comment|"), "s");
}

TEST(Lexer, NumbersThatAreTooLargeAreZeroWithAWarning) {
  EXPECT_EQ(Tokens("9223372036854775808")[0].integer, 0);
  EXPECT_EQ(Tokens("9223372036854775808")[0].Warning(), "Error: bad integer (probably too large)\n");
  EXPECT_EQ(Tokens("1.0e999")[0].real, 0.0);
  EXPECT_EQ(Tokens("1.0e999")[0].Warning(), "Error: bad floating point number\n");
}

TEST(Lexer, TokensKnowTheirPlace) {
  constexpr std::string_view kText = "(state\n   <s> ^a)";
  const std::vector<RuleToken> tokens = Tokens(kText);
  EXPECT_EQ(tokens[2].offset, 10u);
  EXPECT_EQ(tokens[2].length, 3u);
  PlaceFinder places(kText);
  for (const std::size_t offset : {10u, 1u, 10u}) {
    const TextPlace place = places.Find(offset);
    EXPECT_EQ(place.line, offset == 10 ? 2 : 1);
    EXPECT_EQ(place.column, offset == 10 ? 4 : 2);
  }
}

}  // namespace
}  // namespace soarbox::kernel
