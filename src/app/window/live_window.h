// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "app/run_options.h"
#include "app/run_session.h"
#include "app/window/run_window.h"
#include "app/window/window_desk.h"
#include "viewer/viewer.h"

namespace soarbox::app {

/// A time in microseconds, smoothed over about the last second.
class SmoothTime {
 public:
  void Add(std::chrono::steady_clock::duration passed) {
    const double us = std::chrono::duration<double, std::micro>(passed).count();
    us_ = us_ == 0 ? us : us_ + (us - us_) * 0.05;
  }
  double us() const { return us_; }

 private:
  double us_ = 0;
};

/// Submits the window's size, the camera's pose and the user's events as inputs of the simulation; the first two only
/// if they changed.
class Deliverer {
 public:
  void Deliver(viewer::Viewer& viewer, sim::Simulation& simulation);
  /// Drops the user's events, because a past moment is shown.
  static void Drop(viewer::Viewer& viewer) { viewer.TakeEvents(); }

 private:
  sim::ScreenInput screen_;
  sim::CameraInput camera_;
};

/// A run in a visible window: its frames, its ticks at the user's speed, and the panels' desk.
class LiveWindow {
 public:
  LiveWindow(RunSession& session, viewer::Viewer& viewer, workbench::PanelExchange& panels, const WindowRun& run,
             const RunOptions& options);

  /// Runs until the window is closed or the time is over. Returns an ExitCode.
  int Run();

 private:
  using Clock = std::chrono::steady_clock;

  void MakeDesk();
  void Draw();
  void Tick(double step_s);
  /// Serves the user while a script is stopped in the middle of a tick.
  void WaitInTick();
  /// Executes the user's commands for the run. After an error the run cannot continue.
  Result<void> Obey();

  RunSession& session_;
  viewer::Viewer& viewer_;
  workbench::PanelExchange& panels_;
  const sim::Scenario& scenario_;
  const sim::SimulationSettings& settings_;  ///< With the seed of the current run.
  const record::Header& header_;             ///< Of the current run.
  int turn_ticks_;                           ///< sim::TurnTicks of the scenario.
  bool has_script_;                          ///< A script plays the user; the run ends when the script does.
  workbench::Pace pace_;
  LessonDesk lessons_;
  WindowDesk window_desk_;
  std::optional<workbench::Desk> desk_;
  std::vector<viewer::ViewerCommand> postponed_;  ///< Commands for after the tick in which a script is stopped.
  bool was_stopped_ = false;                      ///< A script was stopped in the last tick.
  bool is_closed_ = false;                        ///< The window was closed while a script was stopped.
  Deliverer deliverer_;
  SmoothTime frame_time_, tick_time_;
  Clock::time_point frame_start_ = Clock::now();
  world::SceneSnapshot newest_, previous_;
  std::uint64_t overlays_tick_ = 0;  ///< The tick whose overlays are shown, plus 1; 0: none.
  world::OverlayWants overlay_wants_;
  bool was_live_ = true;
};

}  // namespace soarbox::app
