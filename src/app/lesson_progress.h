// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace soarbox::app {

/// What a learner has done: per lesson whether it is passed, attempts and hints. Written whole, then put in its place;
/// a file that is damaged is kept beside it.
class LessonProgress {
 public:
  /// The user's own.
  LessonProgress();
  /// That of the user whose $XDG_STATE_HOME is this folder.
  static LessonProgress Below(const std::filesystem::path& state);

  bool IsPassed(const std::string& lesson) const { return Get(lesson, "passed") > 0; }
  /// "passed", "attempts", "hints"; 0 if nothing is known.
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
