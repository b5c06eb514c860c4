// SPDX-License-Identifier: BSD-2-Clause
#include "cli/generate_rules.h"

#include <gtest/gtest.h>

namespace soarbox::cli {
namespace {

TEST(GenerateRules, TheFirstListChangesFastest) {
  const GeneratedRules rules = GenerateRules("g (state <s> ^a [1 2]) --> (<s> ^b [x |y z|])", 100);
  ASSERT_EQ(rules.count, 4u);
  EXPECT_EQ(rules.Body(0), "g*1 (state <s> ^a 1) --> (<s> ^b x)");
  EXPECT_EQ(rules.Body(1), "g*2 (state <s> ^a 2) --> (<s> ^b x)");
  EXPECT_EQ(rules.Body(3), "g*4 (state <s> ^a 2) --> (<s> ^b |y z|)");
}

TEST(GenerateRules, BracketsInBarsAreText) {
  const GeneratedRules rules = GenerateRules("g (state <s> ^a |[1 2]|) --> (<s> ^b c)", 100);
  ASSERT_EQ(rules.count, 1u);
  EXPECT_EQ(rules.Body(0), "g*1 (state <s> ^a |[1 2]|) --> (<s> ^b c)");
}

TEST(GenerateRules, ABackslashInAListTakesTheNextCharacterAsItIs) {
  const GeneratedRules rules =
      GenerateRules(R"(g (state <s> ^x <y>) [(<y>\ ^a\ 1) (<y>\ ^b\ [\])] --> (<s> ^b 1))", 100);
  ASSERT_EQ(rules.count, 2u);
  EXPECT_EQ(rules.Body(0), "g*1 (state <s> ^x <y>) (<y> ^a 1) --> (<s> ^b 1)");
  EXPECT_EQ(rules.Body(1), "g*2 (state <s> ^x <y>) (<y> ^b []) --> (<s> ^b 1)");
}

TEST(GenerateRules, WhatCannotBeMadeIsNamed) {
  EXPECT_EQ(GenerateRules("g (state <s> ^a [1 2)", 10).error, "gp syntax error, unmatched values bracket.");
  EXPECT_EQ(GenerateRules("g (a [1 2]) (b [3 4])", 3).error,
            "gp-max exceeded, current production produces 4 productions.");
  EXPECT_FALSE(GenerateRules("g[1 2] (state <s> ^a b)", 10).error.empty());
  EXPECT_FALSE(GenerateRules("", 10).error.empty());
  EXPECT_FALSE(GenerateRules("g (a [])", 10).error.empty());
}

}  // namespace
}  // namespace soarbox::cli
