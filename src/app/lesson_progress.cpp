// SPDX-License-Identifier: BSD-2-Clause
#include "app/lesson_progress.h"

#include <fcntl.h>
#include <unistd.h>

#include <iostream>
#include <optional>
#include <system_error>

#include "diagnostics/read_text.h"
#include "mission/testing.h"

namespace soarbox::app {

namespace fs = std::filesystem;
using ProgressJson = nlohmann::ordered_json;

LessonProgress::LessonProgress() : LessonProgress(mission::StateFolder("learn") / "progress.json") {}

LessonProgress::LessonProgress(fs::path file) : file_(std::move(file)) {
  Read();
}

LessonProgress LessonProgress::Below(const fs::path& state) {
  return LessonProgress(state / "soarbox" / "learn" / "progress.json");
}

void LessonProgress::Read() {
  const std::optional<std::string> text = ReadText(file_);
  if (!text) return;
  data_ = ProgressJson::parse(*text, nullptr, false);
  if (data_.is_object()) return;
  // The damaged file is kept; the lessons can be graded again.
  std::error_code error;
  fs::path damaged = file_;
  damaged += ".damaged";
  fs::rename(file_, damaged, error);
  data_ = ProgressJson::object();
  std::cerr << "soarbox: warning: " << file_.string() << " is damaged; it is kept as " << damaged.filename().string()
            << "; soarbox learn check N grades a lesson again\n";
}

int LessonProgress::Get(const std::string& lesson, const char* what) const {
  if (!data_.is_object() || !data_.contains(lesson) || !data_[lesson].is_object()) return 0;
  const auto at = data_[lesson].find(what);
  return at != data_[lesson].end() && at->is_number() ? at->get<int>() : 0;
}

void LessonProgress::Set(const std::string& lesson, const char* what, int value) {
  // Another window may have written the file since it was read.
  Read();
  if (!data_.is_object()) data_ = ProgressJson::object();
  if (!data_.contains(lesson) || !data_[lesson].is_object()) data_[lesson] = ProgressJson::object();
  data_[lesson][what] = value;
  Save();
}

void LessonProgress::Save() {
  std::error_code error;
  fs::create_directories(file_.parent_path(), error);
  fs::path making = file_;
  making += ".part";
  const std::string text = data_.dump(2) + "\n";
  const int file = open(making.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  bool good =
      file >= 0 && write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()) && fsync(file) == 0;
  if (file >= 0) close(file);
  if (good) fs::rename(making, file_, error);
  good = good && !error;
  if (!good) std::cerr << "soarbox: warning: " << file_.string() << " cannot be written: your progress is not noted\n";
}

}  // namespace soarbox::app
