// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "sim/scenario.h"
#include "workbench/surroundings.h"

namespace soarbox::app {

/// What a window does for a learner: the lesson that its world belongs to, hints one at a time, grading beside the run
/// in a process of its own, and the way to other lessons.
class LessonDesk final : public workbench::Lessons {
 public:
  /// For the lesson of this world; without one it offers lessons all the same.
  LessonDesk(const sim::Scenario& scenario, const std::filesystem::path& lesson);
  ~LessonDesk() override;  ///< Ends grading that still goes on.
  LessonDesk(const LessonDesk&) = delete;
  LessonDesk& operator=(const LessonDesk&) = delete;

  bool HasLesson() const;
  /// The panel that the lesson is about; empty: none.
  std::string Panel() const;
  void Hint() override;
  Result<void> Grade() override;
  void Cancel() override;
  Result<Opened> Open(const std::string& lesson) override;
  bool Poll() override;
  void Fill(workbench::Contents& contents) const override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace soarbox::app
