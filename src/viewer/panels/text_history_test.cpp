// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/text_history.h"

#include <gtest/gtest.h>

namespace soarbox::viewer {
namespace {

TEST(TextHistory, TakesStepsBackAndForth) {
  TextHistory history;
  history.Begin("one");
  EXPECT_FALSE(history.CanUndo());
  history.Note("one two", false);
  history.Note("one two three", false);
  EXPECT_EQ(history.Undo(), "one two");
  EXPECT_EQ(history.Undo(), "one");
  EXPECT_FALSE(history.CanUndo());
  EXPECT_EQ(history.Redo(), "one two");
  EXPECT_EQ(history.changed_at(), 3U);
  EXPECT_EQ(history.Redo(), "one two three");
  EXPECT_FALSE(history.CanRedo());
}

TEST(TextHistory, TakesAWordThatWasTypedAtOnceBackAtOnce) {
  TextHistory history;
  history.Begin("");
  history.Note("a", false);
  history.Note("ab", true);
  history.Note("abc", true);
  history.Note("abc d", false);
  EXPECT_EQ(history.Undo(), "abc");
  EXPECT_EQ(history.Undo(), "");
}

TEST(TextHistory, ForgetsWhatWasUndoneOnceSomethingElseIsTyped) {
  TextHistory history;
  history.Begin("a");
  history.Note("ab", false);
  history.Undo();
  history.Note("ac", true);
  EXPECT_FALSE(history.CanRedo());
  EXPECT_EQ(history.Undo(), "a") << "what is typed after an undo is a step of its own";
}

TEST(TextHistory, KeepsTheNewestStepsOfVeryMany) {
  TextHistory history;
  history.Begin("");
  for (int i = 0; i < 3000; ++i) history.Note(std::string(20'000, static_cast<char>('a' + i % 26)), false);
  int steps = 0;
  for (; history.CanUndo(); ++steps) history.Undo();
  EXPECT_GT(steps, 500);
  EXPECT_LT(steps, 1001);
}

}  // namespace
}  // namespace soarbox::viewer
