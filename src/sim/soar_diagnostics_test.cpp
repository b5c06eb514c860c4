// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include "sim/soar_host.h"

namespace soarbox::sim {
namespace {

TEST(ParseDiagnostics, ReadsPlaceSeverityExcerptAndHint) {
  const auto found = ParseDiagnostics(
      "***\n"
      "scout.soar:14:23: error: variable <t> is not bound\n"
      "   (<s> ^target <t>)\n"
      "                ^~~\n"
      "   note: did you mean <target>?\n"
      "scout.soar:20: warning: suspicious\n",
      "scout.soar");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].file, "scout.soar");
  EXPECT_EQ(found[0].line, 14);
  EXPECT_EQ(found[0].column, 23);
  EXPECT_EQ(found[0].message, "variable <t> is not bound");
  EXPECT_EQ(found[0].excerpt, "(<s> ^target <t>)");
  EXPECT_EQ(found[0].hint, "did you mean <target>?");
  EXPECT_EQ(found[1].severity, Severity::kWarning);
  EXPECT_EQ(found[1].line, 20);
  EXPECT_EQ(found[1].column, 0);
}

TEST(ParseDiagnostics, KeepsTextWithoutAPlaceAsOneProblemOfTheFile) {
  const auto found = ParseDiagnostics("Expected ) to end condition\nError while sourcing file\n", "a.soar");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].file, "a.soar");
  EXPECT_EQ(found[0].message, "Expected ) to end condition; Error while sourcing file");
}

TEST(ParseDiagnostics, FindsNothingInNothing) {
  EXPECT_TRUE(ParseDiagnostics("", "a.soar").empty());
}

}  // namespace
}  // namespace soarbox::sim
