// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace soarbox::app {

/// The learner's progress: for each lesson whether it is tried and passed, attempts and hints. The file is written
/// atomically; a damaged file is kept next to it.
class LessonProgress {
 public:
  /// The current user's progress.
  LessonProgress();
  /// The progress of the user whose $XDG_STATE_HOME is this folder.
  static LessonProgress Below(const std::filesystem::path& state);

  bool IsPassed(const std::string& lesson) const { return Get(lesson, "passed") > 0; }
  /// `what` is "tried", "passed", "attempts" or "hints"; returns 0 if nothing is stored.
  int Get(const std::string& lesson, const char* what) const;
  void Set(const std::string& lesson, const char* what, int value);

 private:
  explicit LessonProgress(std::filesystem::path file);
  void Read();
  void Save();

  std::filesystem::path file_;
  nlohmann::ordered_json data_ = nlohmann::ordered_json::object();
};

}  // namespace soarbox::app
