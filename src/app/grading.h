// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "diagnostics/result.h"

namespace soarbox::app {

/// Grades a learner's rules beside a run: what `soarbox learn check LESSON --progress` prints, from a process of its
/// own. Without processes, another worker of the page does it (grading_absent.cpp).
class Grading {
 public:
  Grading();
  Grading(const Grading&) = delete;
  Grading& operator=(const Grading&) = delete;
  ~Grading();

  /// `folder`: of the learner's lessons; `from`: of the lessons themselves.
  Result<void> Start(const std::string& lesson, const std::filesystem::path& folder, const std::filesystem::path& from);
  bool IsRunning() const { return work_ != nullptr; }
  /// Ends it and everything that it started.
  void Stop();
  /// True if it has ended since.
  bool Poll();
  /// What it has printed until now.
  const std::string& text() const { return text_; }

 private:
  struct Work;
  std::unique_ptr<Work> work_;  ///< Null: nothing is graded.
  std::string text_;
};

}  // namespace soarbox::app
