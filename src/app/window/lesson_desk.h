// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "sim/scenario.h"
#include "viewer/panels/panel_contents.h"

namespace soarbox::app {

/// What a window does for a learner: the lesson that its world belongs to, hints one at a time, grading beside the run
/// in a process of its own, and the way to other lessons.
class LessonDesk {
 public:
  /// For the lesson of this world; without one it offers lessons all the same.
  LessonDesk(const sim::Scenario& scenario, const std::filesystem::path& lesson);
  ~LessonDesk();  ///< Ends grading that still goes on.
  LessonDesk(const LessonDesk&) = delete;
  LessonDesk& operator=(const LessonDesk&) = delete;

  bool HasLesson() const;
  /// The panel that the lesson is about; empty: none.
  std::string Panel() const;
  void Hint();
  /// Begins to grade what lies in the learner's folder.
  Result<void> Grade();
  struct Opened {
    std::string folder;            ///< The learner's, with the world to open.
    std::filesystem::path lesson;  ///< The lesson's own.
  };
  /// Puts another lesson's files into the learner's folder.
  Result<Opened> Open(const std::string& lesson);
  /// Takes over what grading has told; true if something changed.
  bool Poll();
  void Fill(viewer::PanelContents& contents) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace soarbox::app
