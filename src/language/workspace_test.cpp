// SPDX-License-Identifier: BSD-2-Clause
#include "language/workspace.h"

#include <gtest/gtest.h>

namespace soarbox::language {
namespace {

std::string Rules(int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text +=
        "sp {rule*" + std::to_string(i) + "\n   (state <s> ^a" + std::to_string(i) + " b)\n-->\n   (<s> ^c d)\n}\n\n";
  return text;
}

TEST(Workspace, OnlyWhatWasEditedIsReadAgain) {
  Workspace workspace;
  std::string text = Rules(200);
  workspace.Open("/many.soar", text);
  EXPECT_EQ(workspace.reader().reads(), 200U);
  text.insert(text.find("^c d", text.find("rule*100")), "^x <unbound> ");
  workspace.Open("/many.soar", text);
  EXPECT_EQ(workspace.reader().reads(), 201U);
  EXPECT_EQ(workspace.Find("/many.soar")->commands().size(), 200U);
}

TEST(Workspace, ProblemsMoveWithTheirRules) {
  Workspace workspace;
  const std::string wrong = "sp {wrong\n   (state <s> ^a b)\n-->\n   (<x> ^c d)\n}\n";
  workspace.Open("/a.soar", wrong);
  ASSERT_EQ(workspace.Find("/a.soar")->problems().size(), 1U);
  const int line = workspace.Find("/a.soar")->problems().front().line;
  workspace.Open("/a.soar", "# one\n# two\n" + wrong);
  const std::size_t reads = workspace.reader().reads();
  EXPECT_EQ(workspace.Find("/a.soar")->problems().front().line, line + 2);
  EXPECT_EQ(reads, 1U);
}

TEST(Workspace, WhatDoesNotEndIsToldAndTheRestIsRead) {
  Workspace workspace;
  workspace.Open("/a.soar", "sp {open\n   (state <s> ^a b)\n-->\n   (<s> ^c d)\n\n" + Rules(3));
  const auto document = workspace.Find("/a.soar");
  EXPECT_FALSE(document->problems().empty());
  EXPECT_EQ(document->rules().size(), 4U);
}

TEST(Workspace, UnknownCommandsAreToldAndKnownOnesAreNotCarriedOut) {
  Workspace workspace;
  workspace.Open("/a.soar", "cd /tmp\noutput log /tmp/never\nwatsch 3\n");
  const auto& problems = workspace.Find("/a.soar")->problems();
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().line, 3);
}

TEST(Workspace, NamesStartFromWherePushdLeads) {
  Workspace workspace;
  workspace.Open("/a.soar", "pushd door\nsource open.soar\npushd locks\nsource lock.soar\npopd\npopd\nsource b.soar\n");
  const auto& sourced = workspace.Find("/a.soar")->sourced();
  ASSERT_EQ(sourced.size(), 3U);
  EXPECT_EQ(sourced[0].file, "door/open.soar");
  EXPECT_EQ(sourced[1].file, "door/locks/lock.soar");
  EXPECT_EQ(sourced[2].file, "b.soar");
}

}  // namespace
}  // namespace soarbox::language
