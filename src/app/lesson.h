// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/own_world.h"
#include "diagnostics/result.h"
#include "mission/account.h"
#include "mission/test_missions.h"

namespace soarbox::app {

/// A lesson as its folder has it: lesson.toml, a world, a starter, a solution and wrong answers.
struct Lesson {
  std::filesystem::path folder;
  std::string name;  ///< "01-a-rule"
  std::string title, idea, task;
  std::string panel;              ///< Of the window, which the lesson introduces.
  std::vector<std::string> also;  ///< Other panels that it needs for the first time.
  std::string rules;              ///< The learner's file, "porter.soar".
  std::vector<std::string> hints;
  mission::LoadedMission loaded;
  std::optional<OwnWorldRules> own;  ///< The world is the learner's, and graded as own_world.h says.
};

/// All lessons below a folder, in order. What is wrong with one is added to the problems.
std::vector<Lesson> ReadLessons(const std::filesystem::path& folder, const sim::DataFolders& data,
                                std::vector<Diagnostic>& problems);

/// The one in this folder, if it is there and whole; what is wrong with it is added to the problems.
std::optional<Lesson> ReadLesson(const std::filesystem::path& folder, const sim::DataFolders& data,
                                 std::vector<Diagnostic>& problems);
/// Where the program's own lessons are.
std::filesystem::path ShippedLessons(const sim::DataFolders& data);
/// Folders of lessons below a folder, by name; if it has a course.toml, those that it lists, in its order.
std::vector<std::filesystem::path> LessonFolders(const std::filesystem::path& folder);
/// Further courses below a folder of lessons, by name: folders that are no lessons and hold some.
std::vector<std::string> CoursesIn(const std::filesystem::path& folder);
/// The lesson whose files a learner has in this folder: one of the program with the folder's name, in any
/// course, or the folder's own. Empty: none.
std::filesystem::path LessonOf(const std::filesystem::path& folder, const sim::DataFolders& data);

/// Where learners' files go unless they say otherwise: ~/soarbox-lessons.
std::filesystem::path LessonsFolder();
/// Copies those of a lesson's files that the learner lacks; files that exist stay as they are.
Result<void> PrepareLesson(const Lesson& lesson, const std::filesystem::path& folder);

/// The result of grading rules.
struct Grade {
  bool passed = false;
  bool cancelled = false;            ///< The user stopped it: nothing else is to be reported.
  std::vector<Diagnostic> problems;  ///< Rules that do not load: nothing was run. Files without their folders.
  std::vector<Diagnostic> warnings;  ///< Slips in rules that the learner wrote, also of an answer that passes.
  mission::MissionOutcome outcome;
  std::string mistake;      ///< The known mistake that was recognised; empty: none.
  std::size_t example = 0;  ///< Of the outcome's runs, the first that failed.
  /// What went wrong, the cause first: never empty if a run failed.
  std::vector<sim::Finding> findings;
};

/// Called after each seed.
using OnSeed = std::function<void(std::size_t done, std::size_t of)>;

/// Runs the lesson's world with the rules of this folder. `seeds`: how many; 0: all. Ctrl-C cancels it.
Result<Grade> GradeRules(const Lesson& lesson, const std::filesystem::path& rules_folder, std::size_t seeds,
                         const OnSeed& on_seed = {});

}  // namespace soarbox::app
