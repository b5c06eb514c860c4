// SPDX-License-Identifier: BSD-2-Clause
// The texts of every panel over a filled run, and the copied texts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <string_view>

#include "viewer/panels/panel_test_support.h"
#include "workbench/document/glossary.h"

namespace soarbox::viewer {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST_F(Panels, CanBeCopied) {
  stage->SetSize(1280, 720, 100);
  stage->Fill("walker");
  const std::vector<std::pair<workbench::PanelId, const char*>> wanted = {
      {workbench::PanelId::kAgents, "walker"},
      {workbench::PanelId::kMind, "S1"},
      {workbench::PanelId::kMemory, "superstate"},
      {workbench::PanelId::kRules, "sp {walker*propose*flee"},
      {workbench::PanelId::kWhy, "Why does walker"},
      {workbench::PanelId::kLinks, "seek"},
      {workbench::PanelId::kMessages, "I am on my way"},
      {workbench::PanelId::kTimeline, "seek"},
      {workbench::PanelId::kTrace, "seek"},
      {workbench::PanelId::kPlots, "health"},
      {workbench::PanelId::kConsole, "superstate"},
      {workbench::PanelId::kEdit, "walker*propose*seek"},
      {workbench::PanelId::kBreakpoints, "flee"},
      {workbench::PanelId::kProblems, "did you mean"},
      {workbench::PanelId::kMission, "it stood idle for 0 s"},
      {workbench::PanelId::kLongTerm, "No long-term memory is switched on"},
      {workbench::PanelId::kLearning, "No rule has been learned yet."},
      {workbench::PanelId::kExercise, "7:8:9"},
      {workbench::PanelId::kImagery, "wall"},
      {workbench::PanelId::kScript, "Scout.lua:4"},
  };
  for (const auto& [panel, text] : wanted) {
    EXPECT_THAT(stage->Copy(panel), HasSubstr(text)) << InfoOf(panel).word;
  }
}

TEST_F(Panels, EachShowsWhatTheRunHolds) {
  stage->SetSize(1280, 720, 100);
  stage->Fill("walker");
  const std::vector<std::pair<workbench::PanelId, std::vector<const char*>>> wanted = {
      {workbench::PanelId::kAgents, {"walker", "listener", "seek", "operator", "100"}},
      {workbench::PanelId::kMind, {"Goal stack", "propose", "seek", "Standing", "better than"}},
      {workbench::PanelId::kMemory, {"S1", "^superstate", "nil", "^operator"}},
      {workbench::PanelId::kRules, {"walker*apply*seek", "Fired", "Break when it fires", "health"}},
      {workbench::PanelId::kWhy, {"Why does walker do what it does?", "command", "walker*propose*seek", "north"}},
      {workbench::PanelId::kLinks,
       {"Commands (output link)", "seek", "broadcast", "^waypoint north", "Percepts (input link)",
        "Filter by attribute"}},
      {workbench::PanelId::kMessages, {"From", "walker", "team red", "I am on my way"}},
      {workbench::PanelId::kTimeline, {"walker", "seek"}},
      {workbench::PanelId::kTrace, {"seek", "walker"}},
      {workbench::PanelId::kPlots, {"Plot a number of walker", "health", "self.position.x (m)"}},
      {workbench::PanelId::kConsole, {"print s1", "superstate nil"}},
      {workbench::PanelId::kEdit, {"Apply", "walker*propose*seek", "line 14", "variable <t>"}},
      {workbench::PanelId::kBreakpoints, {"stopped", "walker*propose*flee", "Hits"}},
      {workbench::PanelId::kFutures, {"There is only one future so far."}},
      {workbench::PanelId::kProblems, {"error", "variable <t>", "did you mean", "^^^", "walker.soar:14"}},
      {workbench::PanelId::kWatch, {"Nothing is watched yet.", "Side by side:"}},
      {workbench::PanelId::kMinds, {"No mind is shown.", "Side by side:"}},
      {workbench::PanelId::kMission,
       {"1. A rule fires once", "Greet each visitor", "New here: Memory", "Hint 2 of 3", "1. Watch the panel", "Grade",
        "Next lesson", "1 of 3 checks, 1 failed", "it goes north", "0:00.17", "it stood idle for 0 s", "later",
        "once per visit"}},
      {workbench::PanelId::kLongTerm, {"Known 0", "Recalled 0", "Episodes 0", "No long-term memory is switched on"}},
      {workbench::PanelId::kLearning, {"Rules 0", "Episodes 0", "No rule has been learned yet."}},
      {workbench::PanelId::kExercise,
       {"Exercise 3", "239.1.2.3:3000", "machine only", "1:7", "120", "12 too short", "visitor", "2 entities"}},
      {workbench::PanelId::kImagery,
       {"made up", "all of S1", "distance", "X7", "walker*ask", "1.4", "self, wall", "1 more"}},
      {workbench::PanelId::kScript, {"Local variables", "speed = 3", "memory", "gate", "others"}},
  };
  ASSERT_EQ(wanted.size(), workbench::kPanelCount);
  for (const auto& [panel, texts] : wanted) ExpectShown(panel, texts);
  // If there is space, the entire scene and all plots are shown.
  Layout scene = DefaultLayout();
  scene.Move(workbench::PanelId::kImagery, Area::kRight);
  stage->Draw(scene);
  for (const char* text : {"there is no node", "2 nodes", "10.00", "^solid yes"})
    EXPECT_THAT(stage->shown, HasSubstr(text));
  Layout tall = DefaultLayout();
  tall.Move(workbench::PanelId::kPlots, Area::kRight);
  stage->Draw(tall);
  for (const char* text : {"decision time (\xc2\xb5s)", "reward", "0.5"}) EXPECT_THAT(stage->shown, HasSubstr(text));
}

TEST_F(Panels, FollowTheNewestLineOfAConsoleUnlessTheUserReadsEarlierOnes) {
  stage->SetSize(1280, 720, 100);
  stage->Fill("walker");
  debugger::Console console("walker");
  const auto add = [&](const std::string& line) {
    console.Refuse(line, "refused");
    ++stage->contents.console_lines;
  };
  stage->contents.console = &console;
  for (int i = 0; i < 60; ++i) add("line-" + std::to_string(i) + ".");
  ExpectShown(workbench::PanelId::kConsole, {"line-59."});
  int found = 0;
  for (ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows) {
    if (std::string_view(window->Name).find("output walker") == std::string_view::npos) continue;
    ImGui::SetScrollY(window, 0);
    ++found;
  }
  EXPECT_GT(found, 0);
  add("line-60.");
  ExpectShown(workbench::PanelId::kConsole, {"line-0."});
  EXPECT_THAT(stage->shown, Not(HasSubstr("line-60.")));
  stage->Fill("walker");
}

TEST_F(Panels, TellWhatIsKnownTheMostActiveFirstAndHowMuchMoreThereIs) {
  stage->Fill("walker");
  debugger::RecallLog recalls;
  record::MindRecord mind;
  mind.events.Add(mind::Recalled{1, false, 12, "^kind ammo", "^kind ammo ^site @3", "the only one that fits"});
  recalls.Add(5, mind);
  workbench::Contents& contents = stage->contents;
  contents.recalls = &recalls;
  explain::LongTermFacts& facts = contents.long_term.facts;
  contents.long_term.note.clear();
  facts.semantic = facts.episodic = true;
  facts.objects = 5000;
  facts.known = {{12, "^kind ammo ^site @3", 1.25, 3}, {3, "^name barn ^east-of |the old mill|", -0.5, 0}};
  facts.episodes = 40;
  for (const auto& [width, height] : {std::pair{1280, 800}, std::pair{1920, 1080}}) {
    stage->SetSize(width, height, 100);
    ExpectShown(workbench::PanelId::kLongTerm, {"Known 5000", "Recalled 1", "Episodes 40", "The 2 most active.", "@12",
                                                "1.250", "@3", "-0.500", "^kind ammo ^site @3"});
    EXPECT_THAT(stage->complaints, IsEmpty()) << width;
  }
  for (const char* text : {"= Known 5000", "^kind ammo  @12 ^kind ammo ^site @3  the only one that fits"})
    EXPECT_THAT(stage->Copy(workbench::PanelId::kLongTerm), HasSubstr(text));
  facts.known.clear();
  facts.objects = 0;
  ExpectShown(workbench::PanelId::kLongTerm, {"Nothing is known yet."});
}

TEST_F(Panels, ShowLearnedRulesWithTheirReasonsAndDrawOnlyVisibleRows) {
  stage->Fill("walker");
  debugger::LearningLog log;
  record::MindRecord mind;
  mind.events.Add(mind::RuleLearned{1, "chunk*walker*turn*t4-1", {}, {}, mind::StateReason::kTie, true});
  mind.events.Add(mind::ValueUpdated{"rl*walker*1", 0.5});
  mind.events.Add(mind::RewardReceived{2});
  mind.events.Add(mind::EpisodeEnded{});
  log.Add(5, mind);
  mind.events.Clear();
  mind.events.Add(mind::RuleFired{"chunk*walker*turn*t4-1", false});
  mind.events.Add(mind::ValueUpdated{"rl*walker*1", 1.5});
  mind.events.Add(mind::RewardReceived{-1});
  mind.events.Add(mind::EpisodeEnded{});
  log.Add(20, mind);
  workbench::Contents& contents = stage->contents;
  contents.learning_log = &log;
  debugger::LearningView& view = contents.learning;
  view = {};
  view.learners = 1;
  view.numbers = {{"rl*walker*1", "^name turn", 1.5, 0, 1.5, 2}};
  debugger::LearnedRuleRow row;
  row.name = "chunk*walker*turn*t4-1";
  row.tick = 5;
  row.firings = 1;
  row.purpose = "proposes turn";
  row.source = "S2: operator tie in S1";
  view.rules.push_back(row);
  for (int n = 0; n < 20'000; ++n) {
    row.name = "chunk*many*" + std::to_string(n);
    view.rules.push_back(row);
  }
  for (const auto& [width, height] : {std::pair{1280, 800}, std::pair{1920, 1080}}) {
    stage->SetSize(width, height, 100);
    ExpectShown(workbench::PanelId::kLearning, {"Rules 20001", "Values 1", "Episodes 2", "chunk*walker*turn*t4-1",
                                                "proposes turn", "S2: operator tie in S1", "0:00.17"});
    EXPECT_THAT(stage->shown, testing::Not(HasSubstr("chunk*many*100"))) << "only rows that can be seen are drawn";
    EXPECT_THAT(stage->complaints, IsEmpty()) << width;
  }
  debugger::LearnedRuleView& chosen = contents.learned_rule;
  chosen.name = "chunk*walker*turn*t4-1";
  chosen.why = {"learned in the substate S2", debugger::WhyKind::kLearned, chosen.name};
  chosen.why.below.push_back({"why each condition is there"});
  chosen.why.below[0].below.push_back({"(<s> ^operator <o>)", debugger::WhyKind::kCondition});
  chosen.fired = {20};
  ExpectShown(workbench::PanelId::kLearning,
              {"Fired since:", "0:00.67", "learned in the substate S2", "(<s> ^operator <o>)", "Close"});
  EXPECT_THAT(stage->complaints, IsEmpty());
  view.rules.clear();
  view.note = "reinforcement learning is off: rl --set learning on";
  chosen = {};
  stage->Draw(workbench::PanelId::kLearning);
  EXPECT_THAT(stage->shown, HasSubstr("rl*walker*1")) << "values, where no rule was learned";
  view.learners = 0;
  view.numbers.clear();
  ExpectShown(workbench::PanelId::kLearning, {"No rule has been learned yet."});
}

TEST_F(Panels, OfARecordingSayWhatIsNotRecordedAndOfferNothingThatCannotBe) {
  stage->SetSize(1280, 720, 100);
  stage->Fill("walker");
  debugger::RecordedMinds minds(record::Level::kDecisions);
  record::TickRecord tick = stage->last;
  tick.tick = 0;
  for (record::MindRecord& mind : tick.minds) {
    mind.events.Clear();
    mind.events.Add(mind::StateMade{1, "S1", mind::StateReason::kTop, false, {}});
    mind.events.Add(mind::OperatorSelected{1, "O3", "seek", {}});
    mind.events.Add(mind::Remark{"better than the other"});
  }
  ASSERT_FALSE(tick.minds.empty());
  minds.Add(tick);
  const std::unique_ptr<explain::Inspector> mind = minds.Inspect("walker");
  ASSERT_NE(mind, nullptr);
  workbench::Contents& contents = stage->contents;
  contents.moment.is_recording = true;
  contents.moment.is_live = false;
  contents.past_note = "The mind at this moment cannot be rebuilt: the scenario has gone";
  contents.not_recorded = debugger::MemoryAbsence(*mind);
  contents.stack = debugger::LookAtStack(*mind);
  contents.operators = debugger::LookAtOperators(*mind);
  contents.objects = {{"S1", debugger::LookAtObject(*mind, "S1")}};
  contents.rules = debugger::ListRules(*mind);
  contents.long_term = debugger::LookAtLongTerm(*mind);
  contents.learning = debugger::LookAtLearning(*mind);
  contents.rule.reset();
  contents.story.reset();
  const std::vector<std::pair<workbench::PanelId, std::vector<const char*>>> wanted = {
      {workbench::PanelId::kMind,
       {"as recorded", "seek (O3) was selected: as recorded: better than the", "preferences: not recorded"}},
      {workbench::PanelId::kMemory, {"Not recorded at this level"}},
      {workbench::PanelId::kRules, {"Not recorded at this level"}},
      {workbench::PanelId::kBreakpoints, {"Breakpoints stop a run, not a recording."}},
      {workbench::PanelId::kFutures, {"A recording has one future."}},
      {workbench::PanelId::kLongTerm, {"what it knows and remembers: not recorded"}},
      {workbench::PanelId::kLearning, {"what it has learned: not recorded"}},
  };
  for (const auto& [panel, texts] : wanted) {
    ExpectShown(panel, texts);
    EXPECT_THAT(stage->shown, testing::Not(HasSubstr("Resume here")));
    EXPECT_THAT(stage->complaints, IsEmpty()) << InfoOf(panel).word;
  }
}

TEST(Terms, EveryPhaseAndEveryImpasseIsExplained) {
  using workbench::document::MeaningOf;
  for (const std::string& phase : debugger::Phases()) EXPECT_FALSE(MeaningOf(phase).empty()) << phase;
  for (const char* term : {"operator tie", "operator conflict", "operator constraint-failure", "operator no-change",
                           "state no-change", "i-support", "o-support", "operator", "better", "numeric"})
    EXPECT_FALSE(MeaningOf(term).empty()) << term;
  EXPECT_TRUE(MeaningOf("no term of Soar").empty());
}

}  // namespace
}  // namespace soarbox::viewer
