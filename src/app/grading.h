// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::app {

/// Grades a learner's rules during a run, in a separate process that executes `soarbox learn check LESSON --progress`.
/// Without processes, another worker of the page does it (grading_absent.cpp).
class Grading {
 public:
  Grading();
  Grading(const Grading&) = delete;
  Grading& operator=(const Grading&) = delete;
  ~Grading();

  /// `folder` contains the learner's lessons, `from` the lessons themselves.
  Result<void> Start(const std::string& lesson, const std::filesystem::path& folder, const std::filesystem::path& from);
  bool IsRunning() const { return work_ != nullptr; }
  /// Ends the grading with all processes that it started.
  void Stop();
  /// True if it has ended since the last call.
  bool Poll();
  /// Its output so far.
  const std::string& text() const { return text_; }

 private:
  struct Work;
  std::unique_ptr<Work> work_;  ///< Null: no grading runs.
  std::string text_;
};

}  // namespace soarbox::app
