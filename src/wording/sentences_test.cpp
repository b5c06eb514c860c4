// SPDX-License-Identifier: BSD-2-Clause
#include "wording/sentences.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

namespace soarbox::wording {
namespace {

TEST(Sentences, ThePageListsTheTable) {
  const std::string file = std::string(SOARBOX_SOURCE_DIR) + "/docs/dev/answers.md";
  if (std::getenv("WRITE_EXPECTED") != nullptr) std::ofstream(file) << AnswersPage();
  std::ifstream in(file);
  std::ostringstream page;
  page << in.rdbuf();
  EXPECT_EQ(page.str(), AnswersPage()) << "run this test with WRITE_EXPECTED=1 and read what it changed";
}

TEST(Sentences, EachSituationHasItsOwnWordsAndAName) {
  std::set<std::string_view> texts, names;
  for (const Sentence& sentence : Sentences()) {
    EXPECT_FALSE(sentence.when.empty()) << sentence.text;
    EXPECT_TRUE(names.insert(sentence.when).second) << sentence.when;
    EXPECT_TRUE(texts.insert(sentence.text).second) << sentence.text;
    int open = 0;
    for (const char c : sentence.text) {
      open += c == '{' ? 1 : c == '}' ? -1 : 0;
      EXPECT_TRUE(open == 0 || open == 1) << sentence.text;
    }
    EXPECT_EQ(open, 0) << sentence.text;
  }
}

TEST(Sentences, FactsTakeThePlaceOfSlots) {
  EXPECT_EQ(Say(Situation::kMakesBetter, {{"maker", "rule r"}, {"op", "{op}"}, {"other", "b"}}),
            "rule r makes {op} better than b");
  EXPECT_EQ(Say(Situation::kNoRules), "it has no rules");
  const std::string three[] = {"a", "b", "c"};
  EXPECT_EQ(Listed(three), "a, b and c");
  EXPECT_EQ(Listed(std::span(three).first(2)), "a and b");
  EXPECT_EQ(Listed(std::span(three).first(0)), "");
}

}  // namespace
}  // namespace soarbox::wording
