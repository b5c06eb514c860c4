// SPDX-License-Identifier: BSD-2-Clause
#include "sim/mind_notes.h"

#include <gtest/gtest.h>

#include "mind/decision_codec.h"

namespace soarbox::sim {
namespace {

using Lines = std::vector<std::string>;

/// One operator that a rule proposes.
std::string OnlyOne() {
  mind::DecisionView decision;
  decision.operators = {{"O1", "seek"}};
  decision.preferences = {{mind::PreferenceKind::kAcceptable, 0, mind::Decision::kNoOperator, 0, "scout*propose"}};
  decision.left = {{0, 0, 1}};
  decision.selected = 0;
  std::string bytes;
  mind::Pack(decision, bytes);
  return bytes;
}

TEST(MindNotes, PerceptsAreWordedWithPathKeyAndValue) {
  MindNotes notes;
  notes.NotePercept("", {"distance", 0, 12.5});
  notes.NotePercept("agent#3.", {"visible", 0, std::string("yes")});
  notes.NotePercept("self.", {"rounds", 0, std::int64_t{-7}});
  notes.NotePercept("", {"sound", 2, std::string()});
  notes.NotePercept("", {"bearing", 0, 1.0 / 3});
  notes.NotePerceptGone("agent#3.", "path", 4);
  EXPECT_EQ(notes.Words().percepts, (Lines{"distance 12.5", "agent#3.visible yes", "self.rounds -7", "sound#2 ",
                                           "bearing 0.333333", "-agent#3.path#4"}));
}

TEST(MindNotes, DecisionsAreIndentedByLevelAndHaveTheirReasons) {
  MindNotes notes;
  notes.NoteDecided(OnlyOne());
  notes.NoteOperator(1, "O1", "seek");
  notes.NoteDecided(OnlyOne());
  notes.NoteState(2, "S2", "no-change", "operator");
  notes.NoteOperator(2, "O2", "");
  notes.NoteDecided("damaged");
  notes.NoteStateGone(2, "S2");
  notes.NoteState(1, "S1", "none", "state");
  notes.NoteHalt();
  const MindWords words = notes.Words();
  EXPECT_EQ(words.decisions,
            (Lines{"O: O1 (seek)", "   ==>S: S2 (operator no-change)", "   O: O2", "   <==S: S2", "==>S: S1", "halt"}));
  EXPECT_EQ(words.reasons, (Lines{"the only operator proposed, by rule scout*propose", "", "", "", "", ""}));
}

TEST(MindNotes, CommandsHaveTheRuleThatMadeThem) {
  MindNotes notes;
  notes.NoteRuleOfCommand(17, "scout*move");
  notes.NoteRuleOfCommand(18, "scout*shoot");
  notes.NoteCommand("shoot ^at red-1", 18);
  notes.NoteOutcome("move-to", "complete");
  notes.NoteOutcome("aim", "error", "no-target");
  notes.NoteCommand("wander", 19);
  const MindWords words = notes.Words();
  EXPECT_EQ(words.commands, (Lines{"shoot ^at red-1", "move-to: complete", "aim: error no-target", "wander"}));
  EXPECT_EQ(words.command_rules, (Lines{"scout*shoot", "", "", ""}));
}

TEST(MindNotes, DetailsCountTheDecisionsBeforeThemAndCanBeLeftOut) {
  MindNotes notes;
  notes.NoteFiring("scout*propose", false);
  notes.NoteElement(true, 12, "S1", "operator", "O1", true);
  notes.NoteOperator(1, "O1", "seek");
  notes.NoteElement(false, 9, "O1", "name", "seek", false);
  notes.NoteFiring("scout*propose", true);
  EXPECT_EQ(notes.Words().details, (Lines{"0 fire scout*propose", "0 + 12: S1 ^operator O1 +", "1 - 9: O1 ^name seek",
                                          "1 retract scout*propose"}));
  EXPECT_TRUE(notes.Words(false).details.empty());
  EXPECT_EQ(notes.Words(false).decisions.size(), 1u);
}

TEST(MindNotes, ACopyKeepsWhatItWasMadeFrom) {
  MindNotes notes;
  notes.NoteOperator(1, "O1", "seek");
  const MindNotes copy = notes;
  notes.Clear();
  EXPECT_TRUE(notes.empty());
  EXPECT_TRUE(notes.Words().decisions.empty());
  EXPECT_EQ(copy.Words().decisions, Lines{"O: O1 (seek)"});
}

}  // namespace
}  // namespace soarbox::sim
