// SPDX-License-Identifier: BSD-2-Clause
#include "sim/live_edits.h"

#include <gtest/gtest.h>

namespace soarbox::sim {
namespace {

TEST(LiveEdits, ARuleThatChangedReplacesAndOneThatIsGoneIsExcised) {
  const SplitText before =
      SplitRules("sp {a (state <s> ^x 1) --> (<s> ^y 1)}\nsp {b\n (state <s> ^x |}|)\n-->\n (<s> ^y 1)\n}\n# end\n");
  ASSERT_EQ(before.rules.size(), 2u);
  const SplitText after = SplitRules("sp {a (state <s> ^x 2) --> (<s> ^y 1)}\n");
  const std::vector<std::string> edits = EditsBetween(before, after);
  ASSERT_EQ(edits.size(), 2u);
  EXPECT_EQ(edits[0], "excise b");
  EXPECT_EQ(edits[1], "sp {a (state <s> ^x 2) --> (<s> ^y 1)}");
  EXPECT_TRUE(EditsBetween(before, before).empty());
}

TEST(LiveEdits, ARuleThatIsNotClosedIsNamed) {
  EXPECT_EQ(SplitRules("sp {a (state <s> ^x 1)\n-->\n(<s> ^y 1)\n").unclosed, "a");
}

}  // namespace
}  // namespace soarbox::sim
