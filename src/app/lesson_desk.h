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

/// The lesson functions of a window: the lesson of its world, hints one at a time, grading during the run in a separate
/// process, and opening other lessons.
class LessonDesk final : public workbench::Lessons {
 public:
  /// `lesson` is the lesson of this world; without one, the desk still offers lessons.
  LessonDesk(const sim::Scenario& scenario, const std::filesystem::path& lesson);
  ~LessonDesk() override;  ///< Ends a running grading.
  LessonDesk(const LessonDesk&) = delete;
  LessonDesk& operator=(const LessonDesk&) = delete;

  bool HasLesson() const;
  /// The panel that the lesson introduces; empty: none.
  std::string Panel() const;
  void Hint() override;
  Result<void> Grade() override;
  void Cancel() override;
  Result<Opened> Open(const std::string& lesson) override;
  bool Poll() override;
  void NoteTried() override;
  void Fill(workbench::Contents& contents) const override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace soarbox::app
