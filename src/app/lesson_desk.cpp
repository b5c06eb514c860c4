// SPDX-License-Identifier: BSD-2-Clause
#include "app/lesson_desk.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/data_folders.h"
#include "app/grading.h"
#include "app/learn_command.h"
#include "app/lesson.h"
#include "app/lesson_progress.h"
#include "diagnostics/problem.h"
#include "workbench/panel_id.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (end > at) lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

/// The words of the panels that a lesson is about, the most important one first.
std::vector<std::string> NewPanels(const Lesson& lesson) {
  std::vector<std::string> words;
  const auto add = [&](const std::string& title) {
    if (const workbench::PanelInfo* panel = workbench::FindPanelByTitle(title)) words.emplace_back(panel->word);
  };
  add(lesson.panel);
  for (const std::string& title : lesson.also) add(title);
  return words;
}

/// "Memory: Working memory as a tree."
std::string AboutPanel(const Lesson& lesson) {
  const workbench::PanelInfo* panel = workbench::FindPanelByTitle(lesson.panel);
  return panel == nullptr ? "" : "\n\n" + std::string(panel->title) + ": " + std::string(panel->about);
}

}  // namespace

struct LessonDesk::Parts {
  std::vector<Lesson> lessons;
  std::size_t at;       ///< Index of the world's lesson; lessons.size(): none.
  fs::path from, home;  ///< The folder of all lessons; the learner's folder.
  std::vector<std::string> grade;
  bool is_cancelled = false;  ///< Since the last Poll.
  Grading grading;
  LessonProgress progress;

  const Lesson* Now() const { return at < lessons.size() ? &lessons[at] : nullptr; }
  bool IsTried(const Lesson& lesson) const {
    return progress.Get(lesson.name, "tried") > 0 || progress.Get(lesson.name, "attempts") > 0;
  }
};

LessonDesk::LessonDesk(const sim::Scenario& scenario, const fs::path& lesson) : parts_(std::make_unique<Parts>()) {
  parts_->home = LessonsFolder();
  parts_->at = 0;
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return;
  fs::path taught = lesson;
  if (taught.empty() && !scenario.definition.empty() && scenario.rules.empty())
    taught = LessonOf(scenario.definition.parent_path(), *data);
  parts_->from = taught.empty() ? ShippedLessons(*data) : taught.parent_path();
  std::vector<Diagnostic> problems;  // soarbox learn reports them.
  parts_->lessons = ReadLessons(parts_->from, *data, problems);
  const auto is_it = [&](const Lesson& each) { return !taught.empty() && each.name == taught.filename(); };
  const auto found = std::find_if(parts_->lessons.begin(), parts_->lessons.end(), is_it);
  parts_->at = static_cast<std::size_t>(found - parts_->lessons.begin());
  std::error_code error;
  if (parts_->Now() != nullptr)
    parts_->home = fs::absolute(scenario.definition, error).lexically_normal().parent_path().parent_path();
}

LessonDesk::~LessonDesk() = default;

bool LessonDesk::HasLesson() const {
  return parts_->Now() != nullptr;
}

std::string LessonDesk::Panel() const {
  return parts_->Now() != nullptr ? parts_->Now()->panel : std::string();
}

void LessonDesk::Hint() {
  const Lesson* now = parts_->Now();
  if (now == nullptr) return;
  const int used = parts_->progress.Get(now->name, "hints");
  if (used < static_cast<int>(now->hints.size())) parts_->progress.Set(now->name, "hints", used + 1);
}

Result<void> LessonDesk::Grade() {
  const Lesson* now = parts_->Now();
  if (now == nullptr || parts_->grading.IsRunning()) return {};
  parts_->grade.clear();
  return parts_->grading.Start(now->name, parts_->home, parts_->from);
}

void LessonDesk::Cancel() {
  if (!parts_->grading.IsRunning()) return;
  parts_->grading.Stop();
  parts_->grade = {"Grading was cancelled. There is no verdict."};
  parts_->is_cancelled = true;
}

Result<workbench::Lessons::Opened> LessonDesk::Open(const std::string& lesson) {
  for (const Lesson& each : parts_->lessons) {
    if (each.name != lesson) continue;
    const fs::path folder = parts_->home / each.name;
    if (const Result<void> prepared = PrepareLesson(each, folder); !prepared) return prepared.error();
    return Opened{folder.string(), each.folder.string()};
  }
  return NewProblem("there is no lesson '" + lesson + "'");
}

bool LessonDesk::Poll() {
  if (std::exchange(parts_->is_cancelled, false)) return true;
  if (!parts_->grading.IsRunning()) return false;
  const bool has_ended = parts_->grading.Poll();
  std::vector<std::string> lines = LinesOf(parts_->grading.text());
  // Lines of progress come first; the last of them shows the progress.
  const auto is_progress = [](const std::string& line) { return line.starts_with(kProgressLine); };
  if (!has_ended && !lines.empty() && !parts_->grading.text().ends_with('\n')) lines.pop_back();  // An incomplete line.
  const auto result = std::find_if_not(lines.begin(), lines.end(), is_progress);
  if (!has_ended) {
    if (result == lines.begin()) return false;
    std::vector<std::string> now = {*(result - 1)};
    return std::exchange(parts_->grade, now) != now;
  }
  lines.erase(lines.begin(), result);
  parts_->grade = std::move(lines);
  parts_->progress = LessonProgress();
  return true;
}

void LessonDesk::NoteTried() {
  const Lesson* now = parts_->Now();
  if (now != nullptr && !parts_->IsTried(*now)) parts_->progress.Set(now->name, "tried", 1);
}

void LessonDesk::Fill(workbench::Contents& contents) const {
  contents.lessons.clear();
  for (const Lesson& lesson : parts_->lessons)
    contents.lessons.push_back({lesson.name, lesson.title, parts_->progress.IsPassed(lesson.name)});
  contents.lesson.reset();
  const Lesson* now = parts_->Now();
  if (now == nullptr) return;
  workbench::LessonContents& shown = contents.lesson.emplace();
  shown.name = now->name;
  shown.title = std::to_string(parts_->at + 1) + ". " + now->title;
  shown.idea = now->idea + AboutPanel(*now);
  shown.task = now->task;
  shown.panel = now->panel;
  shown.new_panels = NewPanels(*now);
  shown.hint_count = now->hints.size();
  const auto used = static_cast<std::size_t>(std::max(0, parts_->progress.Get(now->name, "hints")));
  shown.hints.assign(now->hints.begin(),
                     now->hints.begin() + static_cast<std::ptrdiff_t>(std::min(used, now->hints.size())));
  shown.is_tried = parts_->IsTried(*now);
  shown.is_passed = parts_->progress.IsPassed(now->name);
  shown.is_graded = parts_->grading.IsRunning();
  shown.grade = parts_->grade;
  if (parts_->at + 1 < parts_->lessons.size()) shown.next = parts_->lessons[parts_->at + 1].name;
}

}  // namespace soarbox::app
