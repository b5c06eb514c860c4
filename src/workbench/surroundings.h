// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "workbench/contents.h"

namespace soarbox::workbench {

/// Help for a learner: hints, a grade, other lessons.
class Lessons {
 public:
  virtual ~Lessons() = default;
  /// Shows the next hint.
  virtual void Hint() = 0;
  /// Starts to grade the learner's files. Poll receives the result.
  virtual Result<void> Grade() = 0;
  /// Stops grading if it is in progress. There is no result then.
  virtual void Cancel() = 0;
  /// The folder of the world that was opened, and the folder of the lesson.
  struct Opened {
    std::string folder, lesson;
  };
  virtual Result<Opened> Open(const std::string& lesson) = 0;
  /// Returns true if anything has changed.
  virtual bool Poll() = 0;
  /// Call it when the learner has changed rules of the running world.
  virtual void NoteTried() = 0;
  /// Fills in Contents::lesson and Contents::lessons.
  virtual void Fill(Contents& contents) const = 0;
};

/// The services that the program around a desk provides. By default, optional services are not available, and the user
/// may write all files.
class Surroundings {
 public:
  virtual ~Surroundings() = default;

  // Control of the run.
  virtual bool IsPaused() const = 0;
  virtual void Pause() = 0;
  virtual void GoOn() = 0;
  /// In simulated seconds per second.
  virtual void SetSpeed(double speed) = 0;

  /// Shows a message to the user at once: what was done, or why it was not.
  virtual void Tell(std::string remark) = 0;

  /// Opens a file in the user's own editor; line 0: no particular line.
  virtual Result<void> OpenInEditor(const std::string& file, int line);
  /// Opens another world or recording instead; `lesson` is the folder of the lesson that it belongs to, or empty.
  virtual Result<void> OpenRun(const std::string& what, const std::string& lesson);
  /// Saves what is shown as a picture.
  virtual void SavePicture() { Tell("There is no picture to save here"); }
  /// Worlds that come with the program.
  virtual std::vector<ScenarioOffer> Scenarios() { return {}; }
  virtual std::vector<std::string> RecentRuns() { return {}; }
  /// Whether the user may browse folders of this machine to open a world.
  virtual bool MayBrowse() const { return false; }
  /// Whether the user's edits may be written to this file.
  virtual bool MayWrite(const std::filesystem::path&) const { return true; }
  /// Whether the file belongs to the user, who may then open it even if the run was not made from it.
  virtual bool IsOwn(const std::filesystem::path&) const { return false; }
  /// Null if there are no lessons.
  virtual Lessons* lessons() { return nullptr; }
};

}  // namespace soarbox::workbench
