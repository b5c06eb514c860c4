// SPDX-License-Identifier: BSD-2-Clause
#include "cli/options.h"

#include <gtest/gtest.h>

namespace soarbox::cli {
namespace {

constexpr OptionSpec kSpecs[] = {
    {'d', "depth", OptionArgument::kRequired}, {'D', "defaults"}, {'t', "tree"}, {'i', "internal"},
    {'w', "wmes", OptionArgument::kOptional},
};

ParsedWords Parse(std::string_view text) {
  CommandReader reader(text);
  std::vector<Word> words;
  reader.Next(words);
  return ParseOptions(words, kSpecs);
}

TEST(ParseOptions, AClusterIsSplitAndOptionsMixWithArguments) {
  const ParsedWords parsed = Parse("s1 -ti --depth 2 x");
  EXPECT_TRUE(parsed.error.empty());
  EXPECT_TRUE(parsed.Has('t') && parsed.Has('i'));
  EXPECT_EQ(parsed.Argument('d'), "2");
  ASSERT_EQ(parsed.arguments.size(), 2u);
  EXPECT_EQ(parsed.arguments[1].text, "x");
}

TEST(ParseOptions, AUniqueBeginningOfALongNameSuffices) {
  EXPECT_TRUE(Parse("--tr").Has('t'));
  EXPECT_EQ(Parse("--de").error, "Ambiguous option, possibilities: '--depth' '--defaults' ");
  EXPECT_EQ(Parse("--nonsense").error, "No such option: nonsense");
}

TEST(ParseOptions, ARequiredArgumentIsTheNextWordEvenFromACluster) {
  EXPECT_EQ(Parse("-depth 2").Argument('d'), "-epth");
  EXPECT_EQ(Parse("--depth").error, "Option 'depth' requires an argument.");
}

TEST(ParseOptions, AnOptionalArgumentDoesNotBeginWithADash) {
  EXPECT_EQ(Parse("--wmes remove").Argument('w'), "remove");
  EXPECT_FALSE(Parse("--wmes -t").Argument('w').has_value());
}

TEST(ParseOptions, OneCharacterIsAnArgumentAndTwoDashesEndTheOptions) {
  EXPECT_EQ(Parse("-").arguments.size(), 1u);
  EXPECT_EQ(Parse("-- -t").arguments.size(), 1u);
}

TEST(ParseOptions, ANegativeNumberIsAnArgument) {
  for (const char* number : {"-1", "-0.5", "-.5", "-1e3", "-2.5e-3"}) {
    const ParsedWords parsed = Parse(number);
    EXPECT_EQ(parsed.error, "") << number;
    ASSERT_EQ(parsed.arguments.size(), 1u) << number;
    EXPECT_EQ(parsed.arguments[0].text, number);
  }
  EXPECT_EQ(Parse("--wmes -5").Argument('w'), "-5");
  EXPECT_EQ(Parse("-1x").error, "No such option: 1");
  constexpr OptionSpec kLevels[] = {{'1', "level-one", OptionArgument::kNone}};
  const std::vector<Word> words = {Word{"-1"}};
  EXPECT_TRUE(ParseOptions(words, kLevels).Has('1')) << "a command that has such an option keeps it";
}

}  // namespace
}  // namespace soarbox::cli
