// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/diagnostic.h"

#include <gtest/gtest.h>

namespace soarbox {
namespace {

TEST(Diagnostic, ShowsThePlaceTheLineAndACaretUnderTheToken) {
  Diagnostic diagnostic;
  diagnostic.file = "scout.soar";
  diagnostic.line = 14;
  diagnostic.column = 5;
  diagnostic.message = "variable <t> is not bound";
  diagnostic.excerpt = "(<s> <t>)";
  diagnostic.column = 6;
  diagnostic.excerpt_length = 3;
  diagnostic.hint = "did you mean <target>?";
  EXPECT_EQ(Format(diagnostic),
            "scout.soar:14:6: error: variable <t> is not bound\n"
            "   (<s> <t>)\n"
            "        ^~~\n"
            "   note: did you mean <target>?\n");
}

TEST(Diagnostic, LeavesOutWhatIsUnknown) {
  Diagnostic diagnostic;
  diagnostic.severity = Severity::kWarning;
  diagnostic.message = "no display";
  EXPECT_EQ(Format(diagnostic), "warning: no display\n");
}

TEST(Diagnostic, TellsInHowManyMorePlacesTheSameIsWrong) {
  Diagnostic diagnostic;
  diagnostic.severity = Severity::kWarning;
  diagnostic.message = "s1 looks like an identifier";
  diagnostic.more = 1;
  EXPECT_EQ(Format(diagnostic), "warning: s1 looks like an identifier\n   note: the same in 1 more place\n");
  diagnostic.more = 12;
  EXPECT_EQ(Format(diagnostic), "warning: s1 looks like an identifier\n   note: the same in 12 more places\n");
}

TEST(Suggest, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(Suggest("abcdef", {"abdcef", "zzzzzz"}), "abdcef");
  EXPECT_EQ(Suggest("abcdef", {"abcde", "abcdfe"}), "abcde");
  EXPECT_EQ(Suggest("move-forwrad", {"move", "move-forward", "move-backward"}), "move-forward");
  EXPECT_EQ(Suggest("ab", {"ba"}), "ba");
  EXPECT_EQ(Suggest("a", {"b"}), "b");
  EXPECT_EQ(Suggest("abcdefghi", {"xbcxefgxi"}), "xbcxefgxi") << "three changes in nine letters";
  EXPECT_EQ(Suggest("abcdefghi", {"xbcxxfgxi"}), "") << "four are too many";
}

TEST(Suggest, AWordOfAnyLengthIsNoNearMissOfAName) {
  const std::string endless(1'000'000, 'a'), letters(20'000, 'b');
  EXPECT_EQ(Suggest(endless, {"print", endless.substr(1), letters}), "");
  EXPECT_EQ(Suggest("input-link", {endless, letters, "input-lnik"}), "input-lnik");
  EXPECT_EQ(Suggest(std::string(100, 'c'), {std::string(99, 'c')}), std::string(99, 'c'));
}

TEST(Suggest, FindsTheNearMissAndStaysSilentOnStrangers) {
  EXPECT_EQ(Suggest("pirnt", {"print", "preferences", "run"}), "print");
  EXPECT_EQ(Suggest("xyzzy", {"print", "preferences", "run"}), "");
}

}  // namespace
}  // namespace soarbox
