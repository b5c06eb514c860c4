// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/lesson_desk.h"
#include "app/next_run.h"
#include "viewer/viewer.h"
#include "workbench/desk.h"
#include "workbench/pace.h"

namespace soarbox::app {

/// Serves a window's panels by a desk, and does what the desk leaves to the window: remarks, pictures, editors, the
/// next run.
class WindowDesk final : public workbench::Surroundings {
 public:
  /// `panels` are those of the viewer's options. `lessons` may be null, for a recording.
  WindowDesk(viewer::Viewer& viewer, workbench::PanelExchange& panels, workbench::Pace& pace, LessonDesk* lessons)
      : viewer_(viewer), panels_(panels), pace_(pace), lessons_(lessons) {}

  /// Call it once per frame.
  void Serve(workbench::Desk& desk);
  /// Whether the user wants to open another scenario or recording instead.
  bool wants_run() const { return wants_run_.has_value(); }
  /// Returns it, if any; resets it.
  std::optional<NextRun> TakeWantedRun() { return std::exchange(wants_run_, std::nullopt); }

  bool IsPaused() const override { return pace_.paused(); }
  void Pause() override { pace_.Pause(); }
  void GoOn() override { pace_.Resume(); }
  void SetSpeed(double speed) override { pace_.SetSpeed(speed); }
  void Tell(std::string remark) override { viewer_.Tell(std::move(remark)); }
  Result<void> OpenInEditor(const std::string& file, int line) override;
  Result<void> OpenRun(const std::string& what, const std::string& lesson) override;
  void SavePicture() override;
  std::vector<workbench::ScenarioOffer> Scenarios() override;
  std::vector<std::string> RecentRuns() override;
  bool MayBrowse() const override { return true; }
  workbench::Lessons* lessons() override { return lessons_; }

 private:
  /// Saves the requested picture of the window, after menus have closed.
  void SaveAwaitedPicture(workbench::Desk& desk);

  viewer::Viewer& viewer_;
  workbench::PanelExchange& panels_;
  workbench::Pace& pace_;
  LessonDesk* lessons_;
  int picture_in_frames_ = 0;         ///< Frames until a picture is saved; 0: none is requested.
  std::optional<NextRun> wants_run_;  ///< To be opened instead of this run.
};

/// Converts a command of a window to a change of pace; nothing for other commands.
std::optional<workbench::Flow> FlowOf(viewer::ViewerCommand command);

}  // namespace soarbox::app
