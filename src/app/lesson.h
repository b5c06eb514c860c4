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
#include "mission/testing.h"

namespace soarbox::app {

/// A lesson as stored in its folder: lesson.toml, a world, a starter, a solution and wrong answers.
struct Lesson {
  std::filesystem::path folder;
  std::string name;  ///< "01-a-rule"
  std::string title, idea, task;
  std::string panel;              ///< The panel of the window that the lesson introduces.
  std::vector<std::string> also;  ///< Other panels that are needed for the first time.
  std::string rules;              ///< The learner's file, "porter.soar".
  std::vector<std::string> hints;
  mission::LoadedMission loaded;
  std::optional<OwnWorldRules> own;  ///< The learner creates the world; own_world.h describes its grading.
};

/// Reads all lessons below a folder, in order. Adds their errors to `problems`.
std::vector<Lesson> ReadLessons(const std::filesystem::path& folder, const sim::DataFolders& data,
                                std::vector<Diagnostic>& problems);

/// Reads the lesson in this folder, if it exists and is complete. Adds its errors to `problems`.
std::optional<Lesson> ReadLesson(const std::filesystem::path& folder, const sim::DataFolders& data,
                                 std::vector<Diagnostic>& problems);
/// Returns the folder of the program's own lessons.
std::filesystem::path ShippedLessons(const sim::DataFolders& data);
/// Returns the folders of lessons below a folder, by name; if its course.toml lists lessons, these, in its order.
std::vector<std::filesystem::path> LessonFolders(const std::filesystem::path& folder);
/// Returns what a course is about: `about` of its course.toml; empty if it does not say it.
std::string AboutCourse(const std::filesystem::path& folder);
/// Returns further courses below a folder of lessons, by name: folders that contain lessons and are none themselves.
std::vector<std::string> CoursesIn(const std::filesystem::path& folder);
/// Returns the folder of the lesson to which the learner's files in `folder` belong: `folder` itself if it contains a
/// lesson, else the program's lesson with the folder's name, in any course. Empty: none.
std::filesystem::path LessonOf(const std::filesystem::path& folder, const sim::DataFolders& data);

/// The default folder of learners' files: ~/soarbox-lessons.
std::filesystem::path LessonsFolder();
/// Copies the files of a lesson that do not exist in `folder`; existing files are unchanged.
Result<void> PrepareLesson(const Lesson& lesson, const std::filesystem::path& folder);

/// The result of grading rules.
struct Grade {
  bool passed = false;
  bool cancelled = false;            ///< The user stopped it: report nothing else.
  std::vector<Diagnostic> problems;  ///< Rules that do not load, so nothing was run. File names without folders.
  std::vector<Diagnostic> warnings;  ///< Slips in the learner's rules, also if the answer passes.
  mission::MissionOutcome outcome;
  std::string mistake;      ///< The known mistake that was recognised; empty: none.
  std::size_t example = 0;  ///< Index of the first failed run in the outcome.
  /// The errors, the cause first; never empty if a run failed.
  std::vector<sim::Finding> findings;
};

/// Called after each seed.
using OnSeed = std::function<void(std::size_t done, std::size_t of)>;

/// Runs the lesson's world with the rules in this folder. `seeds` is the number of seeds; 0: all. Ctrl-C cancels it.
Result<Grade> GradeRules(const Lesson& lesson, const std::filesystem::path& rules_folder, std::size_t seeds,
                         const OnSeed& on_seed = {});

}  // namespace soarbox::app
