// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "workbench/contents.h"

namespace soarbox::workbench {

/// What a learner is offered: hints, a grade, other lessons.
class Lessons {
 public:
  virtual ~Lessons() = default;
  /// Shows the next hint.
  virtual void Hint() = 0;
  /// Begins to grade the learner's files; Poll picks up the result.
  virtual Result<void> Grade() = 0;
  /// Stops grading, if it is under way. There is no verdict then.
  virtual void Cancel() = 0;
  /// Puts another lesson's files into the learner's folder; where its world is, and the lesson's own folder.
  struct Opened {
    std::string folder, lesson;
  };
  virtual Result<Opened> Open(const std::string& lesson) = 0;
  /// True if something has changed.
  virtual bool Poll() = 0;
  /// Fills in `lesson` and `lessons`.
  virtual void Fill(Contents& contents) const = 0;
};

/// The program around a desk: what it alone can do for a user. Where it has nothing to offer, the desk says so.
class Surroundings {
 public:
  virtual ~Surroundings() = default;

  // How fast the run goes.
  virtual bool IsPaused() const = 0;
  virtual void Pause() = 0;
  virtual void GoOn() = 0;
  /// Simulated seconds per second.
  virtual void SetSpeed(double speed) = 0;

  /// Tells the user at once that something was done, or why not.
  virtual void Tell(std::string remark) = 0;

  /// Opens a file in the user's own editor; line 0: anywhere.
  virtual Result<void> OpenInEditor(const std::string& file, int line);
  /// Shows another world or recording instead; `lesson` is the folder of the lesson that it belongs to, or empty.
  virtual Result<void> OpenRun(const std::string& what, const std::string& lesson);
  /// Writes what is shown as a picture.
  virtual void SavePicture() { Tell("There is no picture to save here"); }
  /// Worlds that come with the program, and what was opened before.
  virtual std::vector<ScenarioOffer> Scenarios() { return {}; }
  virtual std::vector<std::string> RecentRuns() { return {}; }
  /// Whether the user may look into folders of this machine to open a world.
  virtual bool MayBrowse() const { return false; }
  /// Whether what the user edits may be written to this file.
  virtual bool MayWrite(const std::filesystem::path&) const { return true; }
  /// Whether a file belongs to the user, who may open it although the run was not made from it.
  virtual bool IsOwn(const std::filesystem::path&) const { return false; }
  /// Null: there are none.
  virtual Lessons* lessons() { return nullptr; }
};

}  // namespace soarbox::workbench
