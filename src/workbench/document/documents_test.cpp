// SPDX-License-Identifier: BSD-2-Clause
// The documents of panels as text: tests/workbench/documents has a file for each panel, with several situations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "workbench/document/curves.h"
#include "workbench/document/filled_run_fixture.h"
#include "workbench/document/panels.h"
#include "workbench/requests_json.h"

namespace soarbox::workbench::document {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

struct Situation {
  const char* title;
  const char* agent;
  std::function<void(Contents&)> change;
};

class Documents : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    run = std::make_unique<FilledRun>();
    run->models.plots.Remove("walker", "decide_us");  // Real time.
  }
  static void TearDownTestSuite() { run.reset(); }

  /// Without the folder of the run's files.
  static std::string TextOf(PanelId panel) {
    std::string text = ToText(DocumentOf(panel, run->contents), run->contents.moment.step_s);
    const std::string folder = run->folder().string() + "/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
      text.erase(at, folder.size());
    return text;
  }

  inline static std::unique_ptr<FilledRun> run;
};

/// The situations for which each panel is tested.
std::vector<Situation> Situations() {
  const auto clear = [](Contents& contents) {
    contents.agents.clear();
    contents.problems.clear();
    contents.agent_count = 0;
    contents.soar_agents.clear();
    contents.checks.clear();
    contents.lesson.reset();
    contents.messages = nullptr;
    contents.plots = nullptr;
    contents.exercise.reset();
    contents.breakpoints.clear();
    contents.hits.clear();
    contents.script.stopped.reset();
    contents.script.stops.clear();
    contents.script.watches.clear();
  };
  return {
      {"an agent that acts", "walker", {}},
      {"an agent in an impasse", "listener-with-a-rather-long-name", {}},
      {"nobody is selected", "", {}},
      {"an empty world", "", clear},
      {"scripts decide for everybody", "walker",
       [](Contents& contents) {
         contents.has_mind = false;
         contents.soar_agents.clear();
         contents.script.stopped.reset();
       }},
      {"the agent has no mind, others have", "walker", [](Contents& contents) { contents.has_mind = false; }},
      {"the mind cannot be looked into", "walker",
       [](Contents& contents) {
         contents.not_available = "Its Soar kernel has gone.";
         contents.script.can_stop = false;
       }},
      {"a recording", "walker",
       [](Contents& contents) {
         contents.moment.is_recording = true;
         contents.lesson.reset();
         contents.past_note = "The minds of this moment are being simulated again: 40 %";
         contents.not_recorded = "Working memory is not recorded at this level.";
         contents.rules.clear();
         contents.rule.reset();
         contents.breakpoints.clear();
       }},
  };
}

TEST_F(Documents, AreAsExpected) {
  for (const PanelInfo& info : kPanelInfos) {
    if (!HasDocument(info.id)) continue;
    std::string text;
    for (const Situation& situation : Situations()) {
      run->Fill(situation.agent);
      for (debugger::AgentRow& agent : run->contents.agents) agent.decide_us = 0;  // Real time.
      if (situation.change) situation.change(run->contents);
      text += "# " + std::string(situation.title) + "\n\n" + TextOf(info.id) + "\n";
    }
    const std::string file =
        std::string(SOARBOX_SOURCE_DIR) + "/tests/workbench/documents/" + std::string(info.word) + ".txt";
    if (std::getenv("WRITE_EXPECTED") != nullptr) std::ofstream(file) << text;
    std::ostringstream expected;
    expected << std::ifstream(file).rdbuf();
    EXPECT_EQ(expected.str(), text) << info.word << ": run this test with WRITE_EXPECTED=1 and read what it changed";
  }
}

/// Calls `each` for all actions in a document's JSON: arrays that begin with an object with a request.
void ForActions(const debugger::Json& json, const std::function<void(const debugger::Json&)>& each) {
  if (json.is_array() && !json.empty() && json[0].is_object() && json[0].contains("request")) return each(json);
  if (!json.is_structured()) return;
  for (const auto& [key, value] : json.items()) ForActions(value, each);
}

TEST_F(Documents, HoldRequestsThatCanBeReadAndPanelsThatExist) {
  std::set<std::string> requests;
  for (const char* agent : {"walker", "listener-with-a-rather-long-name"}) {
    run->Fill(agent);
    run->contents.beside = {"walker"};
    run->contents.watches = {{"S1.operator", {{"walker", "O1", true, false, 3}}}};
    for (const PanelInfo& info : kPanelInfos) {
      ForActions(ToJson(DocumentOf(info.id, run->contents)), [&](const debugger::Json& action) {
        EXPECT_TRUE(ReadRequest(action[0])) << info.word << ": " << action.dump();
        if (action.size() > 1) {
          EXPECT_TRUE(FindPanel(action[1].get<std::string>())) << action.dump();
        }
        requests.insert(action[0]["request"].get<std::string>());
      });
    }
  }
  for (const char* request :
       {"select",       "seek",         "ask",          "rule",      "object",     "element",   "search-memory",
        "break",        "change-break", "watch",        "beside",    "plot",       "imagine",   "coverage",
        "state",        "edit",         "search-known", "line-stop", "error-stop", "script-go", "script-call",
        "script-value", "script-watch", "lesson",       "console",   "complete",   "keep-line"})
    EXPECT_TRUE(requests.contains(request)) << request;
}

TEST_F(Documents, KeepTheKeysOfRowsFromTickToTick) {
  const auto keys = [] {
    std::vector<std::string> found;
    for (const Node& node : DocumentOf(PanelId::kMemory, run->contents))
      if (const auto* tree = std::get_if<Tree>(&node.is))
        for (const TreeRow& row : tree->rows)
          for (const TreeRow& below : row.below) found.push_back(below.key);
    return found;
  };
  run->Fill("walker");
  const std::vector<std::string> before = keys();
  EXPECT_GT(before.size(), 5u);
  run->contents.moment.shown_tick += 1;
  run->contents.objects["S1"].rows[0].element.value = "other";
  EXPECT_EQ(keys(), before);
}

TEST_F(Documents, OfMemoryEndWhereObjectsLeadBackAndBeginWithWhatNothingLeadsTo) {
  run->Fill("walker");
  debugger::MemoryObject& top = run->contents.objects["S1"];
  debugger::MemoryRow loop;
  loop.element = {7, "S1", "self", "S1", false, true};
  top.rows = {loop};
  debugger::MemoryObject other;
  other.id = "X9";
  run->contents.objects["X9"] = other;
  EXPECT_THAT(TextOf(PanelId::kMemory), HasSubstr("^self S1"));
  EXPECT_THAT(TextOf(PanelId::kMemory), HasSubstr("There is no X9 in working memory now."));
  EXPECT_LT(TextOf(PanelId::kMemory).find("X9"), TextOf(PanelId::kMemory).find("\nS1"));
}

TEST_F(Documents, OfMemorySayAllAboutAnElement) {
  run->Fill("walker");
  debugger::ElementStory story;
  story.element = {12, "S1", "speed", "1.500000", false, false};
  mind::MakerFact maker;
  maker.rule = "walker*propose*seek";
  maker.o_supported = true;
  maker.elements = {{3, "S1", "io", "I1", false, true}};
  story.makers = {maker};
  story.testers = {{"walker*apply*seek", 1, false, true}};
  run->contents.story = story;
  const std::string text = TextOf(PanelId::kMemory);
  for (const char* part :
       {"(S1 ^speed 1.500000)", "[Why?]", "[Plot it]", "[Break on such an element]", "[Copy]", "[Close]", "time tag 12",
        "walker*propose*seek, stays until it is removed", "(S1 ^io I1)", "walker*apply*seek, condition 2, in a match"})
    EXPECT_THAT(text, HasSubstr(part));
  run->contents.memory_search = "speed";
  run->contents.found = {story.element};
  EXPECT_THAT(TextOf(PanelId::kMemory), HasSubstr("1 element\n"));
}

TEST_F(Documents, OfProblemsCountThemAndHaveAPageForTheSelectedAgent) {
  run->Fill("walker");
  EXPECT_EQ(BadgeOf(PanelId::kProblems, run->contents), "1");
  EXPECT_THAT(TextOf(PanelId::kProblems), Not(HasSubstr("= All")));
  ProblemRow note;
  note.diagnostic.severity = Severity::kNote;
  note.diagnostic.message = "it waits";
  run->contents.problems.push_back(note);
  EXPECT_EQ(BadgeOf(PanelId::kProblems, run->contents), "1") << "notes are not counted";
  EXPECT_THAT(TextOf(PanelId::kProblems), AllOf(HasSubstr("= All"), HasSubstr("= walker"), HasSubstr("it waits")));
  run->contents.problems.clear();
  EXPECT_EQ(BadgeOf(PanelId::kProblems, run->contents), "");
}

TEST_F(Documents, OfMindsShowWhatAScriptShowsAlsoOfAnAgentWithoutAMind) {
  run->Fill("walker");
  run->contents.shown.rows = {{0, "behavior tree", "", false, 0}, {1, "chase", "yes", true, 12}};
  EXPECT_THAT(TextOf(PanelId::kMind), AllOf(HasSubstr("chase"), HasSubstr("Goal stack")));
  run->contents.has_mind = false;
  const Nodes nodes = DocumentOf(PanelId::kMind, run->contents);
  ASSERT_EQ(nodes.size(), 2u);
  const TableRow& row = std::get<Table>(nodes[1].is).rows.at(1);
  EXPECT_TRUE(row.is_chosen);
  EXPECT_EQ(row.depth, 1);
  EXPECT_EQ(row.hint, "since 0.40 s");
}

TEST_F(Documents, OfMissionsShowChecksAsTheyWereKnownAtTheMoment) {
  run->Fill("walker");
  Contents& contents = run->contents;
  const auto badge = [&] { return BadgeOf(PanelId::kMission, contents); };
  const auto text = [] { return TextOf(PanelId::kMission); };
  EXPECT_EQ(badge(), "1/3") << "markers are not counted";
  EXPECT_THAT(text(), AllOf(HasSubstr("passed: it goes north 0:00.17"), HasSubstr("failed: it rests"),
                            HasSubstr("not decided yet: later")));
  contents.moment.shown_tick = 8;
  EXPECT_THAT(text(), AllOf(HasSubstr("passed: it goes north"), HasSubstr("not decided yet: it rests")));
  contents.moment.shown_tick = 4;
  EXPECT_THAT(text(),
              AllOf(HasSubstr("0 of 3 checks\n"), HasSubstr("not decided yet: it goes north decided at 0:00.17"),
                    HasSubstr("not decided yet: it rests decided at 0:00")))
      << "links lead to the moments";
  contents.moment.shown_tick = 2'000'000;
  EXPECT_EQ(badge(), "2/3");
  // A learner who has not tried anything is not told that a check failed.
  contents.lesson->is_tried = false;
  EXPECT_THAT(text(), AllOf(HasSubstr("2 of 3 checks\n"), HasSubstr("not decided yet: it rests")));
  contents.moment.shown_tick = 4;
  EXPECT_THAT(text(), AllOf(HasSubstr("it goes north decided at"), Not(HasSubstr("it rests decided at"))));
  contents.moment.shown_tick = 2'000'000;
  contents.lesson->is_tried = true;
  // Rules that were changed, and a future that was given up.
  contents.moment.changed_tick = 9;
  EXPECT_THAT(text(), AllOf(HasSubstr("The rules changed while the world ran."), HasSubstr("[Begin again]"),
                            HasSubstr("not decided yet: it goes north"), HasSubstr("passed: later")));
  contents.moment.changed_tick.reset();
  contents.moment.branch_tick = 7;
  EXPECT_THAT(text(), AllOf(HasSubstr("You went on from an earlier moment."), HasSubstr("1 of 3 checks\n"),
                            HasSubstr("passed: it goes north"), HasSubstr("not decided yet: later"),
                            Not(HasSubstr("decided at"))));
}

TEST_F(Documents, OfMissionsWithoutALessonSayWhatIsExpectedUntilItIsSo) {
  run->Fill("walker");
  run->contents.lesson.reset();
  EXPECT_THAT(TextOf(PanelId::kMission),
              AllOf(Not(HasSubstr("walker should be at north")),
                    HasSubstr("walker should stand idle for at least 2 s; it stood idle for 0 s"),
                    HasSubstr("not decided yet: a moment\n    a moment that others refer to"),
                    HasSubstr("walker should be at east by 60 s"), Not(HasSubstr("[Grade]"))));
}

TEST_F(Documents, OfMissionsShowGradesWithoutFoldersAndLeadToTheNextLesson) {
  run->Fill("walker");
  LessonContents& lesson = *run->contents.lesson;
  lesson.grade = {"/var/places/abc/home/01-a-rule/porter.soar:3:4: error: x (see /a/b/c.soar)", "",
                  "  no   anna is greeted", "3 of 10 seeds passed; this was seed 1: soarbox run /x --seed 1"};
  EXPECT_THAT(
      TextOf(PanelId::kMission),
      HasSubstr("Grade\n  porter.soar:3:4: error: x (see c.soar)\n  no: anna is greeted\n  3 of 10 seeds passed; "
                "this was seed 1\n"));
  lesson.grade = {"Passed with all of 10 seeds.", "  yes  anna is greeted"};
  lesson.is_passed = true;
  EXPECT_THAT(
      TextOf(PanelId::kMission),
      AllOf(HasSubstr("You have passed: 1. A rule fires"), HasSubstr("[Next lesson] Operators 1 of 2 lessons passed"),
            HasSubstr("yes: anna is greeted"), HasSubstr("[Grade] [Hint 2 of 3]\n")));
  lesson.next.clear();
  EXPECT_THAT(TextOf(PanelId::kMission), HasSubstr("That was the last lesson."));
  lesson.is_graded = true;
  lesson.grade = {"seed 3 of 10"};
  lesson.hint_count = 1;
  EXPECT_THAT(TextOf(PanelId::kMission),
              AllOf(HasSubstr("Grading: seed 3 of 10"), HasSubstr("[Grading ...] [No more hints] [Cancel]")));
}

TEST_F(Documents, OfMissionsHaveNewsWhenAGradeOrAHintComes) {
  run->Fill("walker");
  LessonContents& lesson = *run->contents.lesson;
  const auto news = [](std::string_view part) {
    for (const Node& node : DocumentOf(PanelId::kMission, run->contents))
      if (const auto* section = std::get_if<Section>(&node.is); section != nullptr && section->key.starts_with(part))
        return section->news.value_or("none");
    return std::string("no such section");
  };
  lesson.grade.clear();
  EXPECT_EQ(news("grade"), "");
  lesson.is_graded = true;
  EXPECT_EQ(news("grade"), "grading");
  lesson.grade = {"seed 3 of 10"};
  EXPECT_EQ(news("grade"), "grading") << "progress is no news";
  lesson.is_graded = false;
  EXPECT_EQ(news("grade"), "seed 3 of 10\n");
  EXPECT_EQ(news("hints"), "1");
  lesson.hints.clear();
  EXPECT_EQ(news("hints"), "");
}

TEST_F(Documents, OfConsolesHoldWhatWasSaidAndALineThatCanBeCompleted) {
  run->Fill("walker");
  Contents& contents = run->contents;
  contents.begun_line = "matches w";
  contents.completed_line = "pri";
  contents.completion = {0, {"print"}, "print"};
  EXPECT_THAT(TextOf(PanelId::kConsole), AllOf(HasSubstr("> print s1\n"), HasSubstr("^superstate nil"),
                                               HasSubstr("[Clear] walker>{matches w} [Send]")));
  const debugger::Json json = ToJson(DocumentOf(PanelId::kConsole, contents));
  const debugger::Json& field = json[1]["nodes"][1]["fields"][0];
  EXPECT_EQ(field["command"]["words"].dump(), R"(["print"])");
  EXPECT_EQ(field["command"]["complete"][0]["request"], "complete");
  EXPECT_EQ(field["label"], "A Soar command for walker");
  EXPECT_EQ(field["prompt"], "walker>");
  // Lines that name a place in a file lead there.
  debugger::Console console("walker");
  console.Refuse("print", "see walker.soar:3 about it");
  contents.console = &console;
  const Nodes nodes = DocumentOf(PanelId::kConsole, contents);
  const Transcript& lines = std::get<Transcript>(nodes.at(0).is);
  ASSERT_EQ(lines.lines.size(), 2u);
  EXPECT_FALSE(lines.lines[0].action);
  EXPECT_TRUE(lines.lines[1].action);
  contents.has_mind = false;
  console.Clear();
  EXPECT_THAT(TextOf(PanelId::kConsole), HasSubstr("walker has no Soar mind. Type Lua for its script"));
}

TEST_F(Documents, OfFuturesBeginWithWhoDecidedOtherwise) {
  run->Fill("walker");
  FuturesContents& futures = run->contents.futures.emplace();
  futures.branch_tick = 30;
  EXPECT_THAT(TextOf(PanelId::kFutures), HasSubstr("So far both futures are the same."));
  futures.comparison.difference = record::Difference{31, "walker", "rules", "old text", "new text"};
  futures.comparison.decision = record::Difference{33, "walker", "operator", "seek", ""};
  futures.comparison.percepts = {"self.health 80, before 100"};
  for (int i = 0; i < 3; ++i) {
    record::Comparison::Moment moment;
    moment.time_s = 1 + i;
    moment.mean_distance_m = i;
    futures.comparison.course.push_back(moment);
  }
  const std::string text = TextOf(PanelId::kFutures);
  for (const char* part :
       {"First other decision or command", "before: seek", "now: nothing", "perceived self.health 80",
        "The run went back to 0:01.00 and went on from there.", "What differed first: walker rules", "How far apart",
        "mean distance (m): 3 points, 0 to 2, last 2"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(Documents, OfLongTermMemoryTakeAlikeEpisodesTogether) {
  run->Fill("walker");
  Contents& contents = run->contents;
  contents.long_term.note.clear();
  contents.long_term.facts.episodic = true;
  contents.long_term.facts.episodes = 60;
  for (std::uint64_t n = 1; n <= 60; ++n) contents.long_term.facts.decisions.push_back(n < 3 ? 0 : 100 + n);
  contents.long_term.facts.changed = {1, 31, 46, 47};
  contents.episode.number = 40;
  contents.episode.time_s = 2.1;
  contents.episode.lines = {"io.input-link.time 2.1"};
  const auto told = [](std::size_t number) {
    run->contents.episode.number = number;
    return TextOf(PanelId::kLongTerm);
  };
  EXPECT_THAT(told(40), HasSubstr("Episodes 31 to 45 of 60, all alike, at 2.10 s, taken in decisions 131 to 145"));
  EXPECT_THAT(told(46), HasSubstr("Episode 46 of 60, at 2.10 s, taken in decision 146"));
  EXPECT_THAT(told(60), HasSubstr("Episodes 47 to 60 of 60, all alike, at 2.10 s, taken in decisions 147 to 160"));
  EXPECT_THAT(told(1), HasSubstr("Episodes 1 to 30 of 60, all alike, at 2.10 s, from an earlier run"));
  contents.episode = {};
}

TEST(Curves, KeepTheirEndsAndTheirPeaksWhenTheyAreThinned) {
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < 20'000; ++i) points.emplace_back(i, i == 7'777 ? 100 : i % 3);
  const auto thinned = Thinned(points);
  EXPECT_LE(thinned.size(), kMostPoints);
  EXPECT_EQ(thinned.front(), points.front());
  EXPECT_EQ(thinned.back(), points.back());
  EXPECT_THAT(thinned, testing::Contains(points[7'777]));
  EXPECT_TRUE(std::ranges::is_sorted(thinned));
}

}  // namespace
}  // namespace soarbox::workbench::document
