// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/drafts.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "record/ticks_test_support.h"
#include "workbench/recent.h"

namespace soarbox::workbench {
namespace {

TEST(Drafts, AreKeptByFileAndDropped) {
  const record::ScratchFolder scratch;
  const Drafts drafts(scratch.path() / "state");
  const std::filesystem::path one = scratch.path() / "a" / "rules.soar", other = scratch.path() / "b" / "rules.soar";
  EXPECT_FALSE(drafts.Find(one));
  ASSERT_TRUE(drafts.Keep(one, "sp {x\n--> }\n"));
  ASSERT_TRUE(drafts.Keep(other, ""));
  EXPECT_EQ(drafts.Find(one), "sp {x\n--> }\n");
  EXPECT_EQ(drafts.Find(other), "") << "somebody has deleted everything";
  ASSERT_TRUE(drafts.Keep(one, "second"));
  EXPECT_EQ(drafts.Find(one), "second");
  drafts.Drop(one);
  EXPECT_FALSE(drafts.Find(one));
  EXPECT_TRUE(drafts.Find(other));
}

TEST(Drafts, SayWhenTheyCannotBeKept) {
  const record::ScratchFolder scratch;
  std::ofstream(scratch.path() / "file") << "no folder";
  const Result<void> kept = Drafts(scratch.path() / "file").Keep("x.soar", "text");
  ASSERT_FALSE(kept);
  EXPECT_NE(kept.error().message.find("draft"), std::string::npos);
  EXPECT_TRUE(Drafts({}).Keep("x.soar", "text")) << "without a home nothing is kept";
}

TEST(RecentRuns, AreTheNewestFirstAndOnce) {
  const record::ScratchFolder scratch;
  setenv("XDG_STATE_HOME", scratch.path().c_str(), 1);
  for (const char* what : {"soar_seek", "soar_flee", "soar_seek", "/no/such/file.soarrec"}) NoteRecentRun(what);
  EXPECT_EQ(RecentRuns(), (std::vector<std::string>{"soar_seek", "soar_flee"})) << "what is gone is left out";
  for (int i = 0; i < 40; ++i) NoteRecentRun("world-" + std::to_string(i));
  EXPECT_LE(RecentRuns().size(), 12U);
  EXPECT_EQ(RecentRuns().front(), "world-39");
  unsetenv("XDG_STATE_HOME");
}

}  // namespace
}  // namespace soarbox::workbench
