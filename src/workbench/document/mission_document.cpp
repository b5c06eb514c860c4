// SPDX-License-Identifier: BSD-2-Clause
// Mission: the task of a lesson with its grade and hints, and the checks of the run.
#include <algorithm>
#include <utility>

#include "workbench/checks.h"
#include "workbench/document/build.h"
#include "workbench/document/panels.h"
#include "workbench/flow_info.h"

namespace soarbox::workbench::document {
namespace {

using What = LessonRequest::What;

/// Replaces the paths of files by their names: "/home/me/01/porter.soar:3" becomes "porter.soar:3".
std::string WithoutFolders(std::string text) {
  constexpr std::string_view kBefore = " \t\"'(", kEnd = " \t\n\"':";
  for (std::size_t at = text.find('/'); at != std::string::npos; at = text.find('/', at + 1)) {
    if (at > 0 && kBefore.find(text[at - 1]) == std::string_view::npos) continue;
    const std::size_t end = std::min(text.find_first_of(kEnd, at), text.size());
    const std::size_t name = text.rfind('/', end - 1) + 1;
    if (name > at + 1 && name < end) text.erase(at, name - at);
  }
  return text;
}

/// A line of a grade without the command that shows the run in a window.
std::string GradeLine(const std::string& line) {
  std::string text = WithoutFolders(line.substr(0, line.find(": soarbox run ")));
  text.erase(text.find_last_not_of(" \t\r") + 1);
  return text;
}

/// The result in a line of a grade such as "  no   once per visit"; open if the line is about something else.
CheckResult ResultIn(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == std::string_view::npos) return CheckResult::kOpen;
  line.remove_prefix(begin);
  return line.starts_with("yes  ")  ? CheckResult::kPassed
         : line.starts_with("no  ") ? CheckResult::kFailed
                                    : CheckResult::kOpen;
}

/// The lines of a grade after its headline. Neighbouring results are one list.
void AddGradeLines(const std::vector<std::string>& lines, Nodes& nodes) {
  for (const std::string& line : lines) {
    std::string text = GradeLine(line);
    if (text.empty()) continue;
    const CheckResult result = ResultIn(text);
    if (result == CheckResult::kOpen) {
      nodes.push_back(Text(std::move(text)));
      continue;
    }
    if (nodes.empty() || !std::holds_alternative<Checklist>(nodes.back().is)) nodes.push_back(Checklist{});
    std::vector<Checklist::Item>& items = std::get<Checklist>(nodes.back().is).items;
    text.erase(0, text.find_first_not_of(' ', text.find_first_not_of(' ') + 3));
    items.push_back({text, result, result == CheckResult::kPassed ? "yes" : "no", {{text}}});
  }
}

bool IsPass(const LessonContents& lesson) {
  return !lesson.is_graded && !lesson.grade.empty() && lesson.grade.front().starts_with("Passed with all");
}

/// The button that opens the next lesson.
Button NextLesson(const LessonContents& lesson) {
  return {"Next lesson", Action{LessonRequest{What::kOpen, lesson.next}},
          "Every lesson is open, whether this one is passed or not"};
}

/// The title of a lesson.
std::string TitleOf(const Contents& contents, const std::string& name) {
  const auto offer = std::ranges::find(contents.lessons, name, &LessonOffer::name);
  return offer == contents.lessons.end() ? name : offer->title;
}

/// The progress of the grading, or its result: the headline and its reasons. A pass leads to the next lesson.
Section GradeSection(const Contents& contents) {
  const LessonContents& lesson = *contents.lesson;
  Section grade{"grade " + lesson.name, {}, {}};
  grade.news = lesson.is_graded ? "grading" : std::string();
  if (!lesson.is_graded && lesson.grade.empty()) return grade;
  grade.title = {{"Grade", Role::kStrong}};
  const std::string headline = lesson.grade.empty() ? std::string() : GradeLine(lesson.grade.front());
  if (lesson.is_graded) {
    grade.box = Role::kName;
    grade.nodes.push_back(Text(headline.empty() ? "Grading ..." : "Grading: " + headline));
    return grade;
  }
  for (const std::string& line : lesson.grade) *grade.news += line + "\n";
  const bool is_pass = IsPass(lesson);
  grade.box = is_pass ? Role::kGood : Role::kWarn;
  if (is_pass)
    grade.nodes.push_back(Paragraph{Paragraph::Style::kTitle, {{"You have passed: " + lesson.title, Role::kGood}}});
  const bool has_headline = ResultIn(headline) == CheckResult::kOpen;
  if (has_headline) grade.nodes.push_back(Text(headline, Role::kStrong));
  if (is_pass) {
    const auto passed = std::ranges::count_if(contents.lessons, &LessonOffer::is_passed);
    Line line;
    if (!lesson.next.empty()) {
      Button next = NextLesson(lesson);
      next.is_main = true;
      line.nodes.push_back(std::move(next));
      line.nodes.push_back(Text(TitleOf(contents, lesson.next)));
    }
    if (lesson.next.empty()) line.nodes.push_back(Text("That was the last lesson."));
    if (!contents.lessons.empty())
      line.nodes.push_back(Text(
          std::to_string(passed) + " of " + std::to_string(contents.lessons.size()) + " lessons passed", Role::kQuiet));
    grade.nodes.push_back(std::move(line));
  }
  AddGradeLines({lesson.grade.begin() + (has_headline ? 1 : 0), lesson.grade.end()}, grade.nodes);
  return grade;
}

Section HintsSection(const LessonContents& lesson) {
  Section hints{"hints " + lesson.name, {}, {}};
  hints.news = lesson.hints.empty() ? std::string() : std::to_string(lesson.hints.size());
  if (lesson.hints.empty()) return hints;
  hints.title = {{"Hints", Role::kStrong}};
  hints.box = Role::kName;
  int number = 0;
  for (const std::string& hint : lesson.hints) hints.nodes.push_back(Text(std::to_string(++number) + ". " + hint));
  return hints;
}

/// Links to the panels that this lesson is about.
Node NewPanels(const Contents& contents) {
  Spans spans{Quiet("New here: ")};
  for (const std::string& word : contents.lesson->new_panels) {
    const std::optional<PanelId> panel = FindPanel(word);
    if (!panel) continue;
    if (spans.size() > 1) spans.push_back(Quiet(", "));
    spans.push_back({std::string(InfoOf(*panel).title), Role::kName, Action{SelectRequest{contents.agent}, panel},
                     std::string(InfoOf(*panel).about)});
  }
  return Text(std::move(spans));
}

void AddLesson(const Contents& contents, Nodes& nodes) {
  const LessonContents& lesson = *contents.lesson;
  nodes.push_back(Paragraph{Paragraph::Style::kTitle, {{lesson.title, Role::kStrong}}});
  nodes.push_back(GradeSection(contents));
  if (lesson.is_passed) nodes.push_back(Text("You have passed this lesson.", Role::kGood));
  nodes.push_back(HintsSection(lesson));
  // Once the learner has begun, the idea is folded.
  nodes.push_back(Section{"idea " + lesson.name + (lesson.is_tried ? " tried" : ""),
                          {{"Idea", Role::kStrong}},
                          {Text(lesson.idea)},
                          !lesson.is_tried});
  Section task{"task", {{"Task", Role::kStrong}}, {Text(lesson.task)}};
  task.box = Role::kName;
  nodes.push_back(std::move(task));
  if (!lesson.new_panels.empty()) nodes.push_back(NewPanels(contents));
}

std::string_view Says(const CheckRow& check, CheckResult result) {
  if (result == CheckResult::kPassed) return "passed";
  if (result == CheckResult::kFailed) return "failed";
  return check.state == "untested"    ? "nothing to test yet"
         : check.state == "undecided" ? "undecided"
                                      : "not decided yet";
}

/// A check with what it expects, unless it is passed. The checks of lessons have names that say it.
Checklist::Item ItemOf(const Contents& contents, const CheckRow& check) {
  const CheckResult result = ResultOf(check, contents);
  Checklist::Item item{check.name, result,        std::string(Says(check, result)), {{check.name, Role::kStrong}},
                       {},         check.expected};
  const bool is_later = result == CheckResult::kOpen && IsDecidedLater(check, contents);
  if ((result != CheckResult::kOpen || is_later) && check.tick > 0) {
    item.spans.push_back({is_later ? " decided at " : " ", is_later ? Role::kQuiet : Role::kPlain});
    item.spans.push_back(Time(check.tick));
  }
  if (!contents.lesson && result != CheckResult::kOpen && !check.agent.empty()) {
    item.spans.front().action = Action{SelectRequest{check.agent}};
    item.spans.front().hint = "Select the agent that decided it";
  }
  if (result == CheckResult::kPassed) return item;
  const bool is_undecided =
      result == CheckResult::kOpen && !check.was.empty() && check.state != "true" && check.state != "false";
  if (!contents.lesson) item.below.push_back(Quiet(check.is_marker ? "a moment that others refer to" : check.expected));
  if (result != CheckResult::kFailed && !is_undecided) return item;
  if (!item.below.empty() && !check.was.empty()) item.below.push_back(Quiet("; "));
  if (!check.was.empty()) item.below.push_back({check.was, result == CheckResult::kFailed ? Role::kBad : Role::kWarn});
  return item;
}

Section ChecksSection(const Contents& contents) {
  Section section{"checks", {{"Checks", Role::kStrong}}, {}};
  const CheckCounts counts = CountChecks(contents);
  section.nodes.push_back(Progress{std::to_string(counts.passed) + " of " + std::to_string(counts.all) + " checks" +
                                       (counts.failed > 0 ? ", " + std::to_string(counts.failed) + " failed" : ""),
                                   counts.passed, counts.all});
  if (std::string why = WhyChecksAreOpen(contents.moment); !why.empty()) {
    const FlowInfo& begin = InfoOf(Flow::kReset);
    Section note{"note", {}, {}};
    note.box = Role::kWarn;
    note.nodes.push_back(Text(std::move(why)));
    note.nodes.push_back(Button{std::string(begin.button), Action{FlowRequest{}}, std::string(begin.meaning)});
    section.nodes.push_back(std::move(note));
  }
  Checklist list;
  for (const CheckRow& check : contents.checks)
    if (!check.is_marker || !contents.lesson) list.items.push_back(ItemOf(contents, check));
  section.nodes.push_back(std::move(list));
  if (contents.lesson)
    section.nodes.push_back(
        Text("The checks follow this one run. The grade runs your rules from the beginning, with "
             "several seeds.",
             Role::kQuiet));
  return section;
}

Actions ActionsOf(const Contents& contents) {
  const LessonContents& lesson = *contents.lesson;
  Actions actions;
  Button grade{lesson.is_graded ? "Grading ..." : "Grade", Action{LessonRequest{What::kGrade}},
               "Runs your saved rules with ten seeds and says whether the lesson is passed"};
  grade.is_enabled = !lesson.is_graded;
  grade.is_main = true;
  actions.nodes.push_back(std::move(grade));
  if (const std::size_t shown = lesson.hints.size(); lesson.hint_count > 0) {
    Button hint{shown >= lesson.hint_count
                    ? "No more hints"
                    : "Hint " + std::to_string(shown + 1) + " of " + std::to_string(lesson.hint_count),
                Action{LessonRequest{What::kHint}}, "A nudge first, then the idea, then the outline of the rule"};
    hint.is_enabled = shown < lesson.hint_count;
    actions.nodes.push_back(std::move(hint));
  }
  if (!lesson.next.empty() && !IsPass(lesson)) actions.nodes.push_back(NextLesson(lesson));
  // The last one, so that no other button takes its place when grading ends.
  if (lesson.is_graded)
    actions.nodes.push_back(
        Button{"Cancel", Action{LessonRequest{What::kCancel}}, "Stops grading. There is no verdict then."});
  return actions;
}

}  // namespace

Nodes MissionDocument(const Contents& contents) {
  const bool has_checks = std::ranges::any_of(contents.checks, [](const CheckRow& check) { return !check.is_marker; });
  if (!contents.lesson && !has_checks)
    return {Empty("This world has no mission.",
                  "Write what its agents are to do as [[check]] tables into scenario.toml or mission.toml "
                  "(docs/missions.md). Worlds of Lua scripts alone are checked by soarbox test.")};
  Nodes nodes;
  if (contents.lesson) AddLesson(contents, nodes);
  if (has_checks) nodes.push_back(ChecksSection(contents));
  if (contents.lesson) nodes.push_back(ActionsOf(contents));
  return nodes;
}

}  // namespace soarbox::workbench::document
