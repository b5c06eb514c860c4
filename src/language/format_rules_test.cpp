// SPDX-License-Identifier: BSD-2-Clause
#include "language/format_rules.h"

#include <gtest/gtest.h>

namespace soarbox::language {
namespace {

TEST(FormatRules, AttributesStandBelowTheFirstOfTheirClause) {
  EXPECT_EQ(FormatRules("sp {a\n(state <s> ^b c   \n -^d e\n^f g)\n  -->\n\t(<s> ^h i)\n  }"),
            "sp {a\n   (state <s> ^b c\n             -^d e\n              ^f g)\n-->\n   (<s> ^h i)\n}\n");
}

TEST(FormatRules, NegatedConjunctionsStandInTheirBraces) {
  EXPECT_EQ(FormatRules("sp {a\n(state <s> ^b <c>)\n-{(<c> ^d <e>)\n(<e> ^f g)}\n-->\n(<s> ^h i)\n}\n"),
            "sp {a\n   (state <s> ^b <c>)\n   -{(<c> ^d <e>)\n      (<e> ^f g)}\n-->\n   (<s> ^h i)\n}\n");
}

TEST(FormatRules, WhatIsQuotedOrNoRuleStays) {
  const std::string text = "sp {a\n   (state <s> ^b |two\n   words  |)\n-->\n   (<s> ^h i)\n}\n\n   echo  x\n# c\n";
  EXPECT_EQ(FormatRules(text), text);
}

TEST(FormatRules, TwiceIsTheSameAsOnceForAnyText) {
  for (const char* text : {"", "\n\n", "sp {", "sp {a\n(((\n)))\n}}}\n", "|\nx\n", "# \n\n\n#", "sp {a |\n (x ^y\nz",
                           "}\n-->\n(", "\"\r\r\n"}) {
    const std::string once = FormatRules(text);
    EXPECT_EQ(FormatRules(once), once) << text;
  }
}

}  // namespace
}  // namespace soarbox::language
