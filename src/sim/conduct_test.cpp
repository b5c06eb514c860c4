// SPDX-License-Identifier: BSD-2-Clause
#include "sim/conduct.h"

#include <gtest/gtest.h>

#include "vocabulary/vocabulary.h"

namespace soarbox::sim {
namespace {

TEST(Conduct, EachCommandHasItsConductAndEachConductItsRow) {
  std::size_t conducts = 0;
  for (const auto& family :
       {MovingConducts(), FollowingConducts(), FightingConducts(), CarryingConducts(), OtherConducts()}) {
    conducts += family.size();
    for (const Conduct& conduct : family)
      EXPECT_NE(vocabulary::FindCommand(conduct.command), nullptr) << conduct.command;
  }
  EXPECT_EQ(conducts, vocabulary::Commands().size());
  for (const vocabulary::CommandRow& row : vocabulary::Commands())
    EXPECT_NE(FindConduct(row.name), nullptr) << row.name;
}

}  // namespace
}  // namespace soarbox::sim
