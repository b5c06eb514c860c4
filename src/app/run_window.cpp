// SPDX-License-Identifier: BSD-2-Clause
#include "app/run_window.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <utility>

#include "app/exit_codes.h"
#include "viewer/viewer.h"
#include "world/world.h"

namespace soarbox::app {

const bool kHasWindow = true;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1, 2, 4, 8, 16};
/// A slow machine slows the world down rather than falling ever further behind.
constexpr int kMostTicksPerFrame = 64;
constexpr auto kLongestFrame = std::chrono::milliseconds(100);

/// The user's hold on the flow of time, and the simulated time that the wall clock has earned.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}

  void Obey(viewer::ViewerCommand command) {
    switch (command) {
      case viewer::ViewerCommand::kTogglePause:
        paused_ = !paused_;
        break;
      case viewer::ViewerCommand::kSingleStep:
        paused_ = true;
        ++steps_;
        break;
      case viewer::ViewerCommand::kFaster:
        speed_ = NextFaster(speed_);
        break;
      case viewer::ViewerCommand::kSlower:
        speed_ = NextSlower(speed_);
        break;
      case viewer::ViewerCommand::kQuit:
        quit_ = true;
        break;
    }
  }

  /// How many ticks of `step_s` are due now.
  int TicksDue(double step_s) {
    const Clock::time_point now = Clock::now();
    const Clock::duration passed = std::min<Clock::duration>(now - last_, kLongestFrame);
    last_ = now;
    if (paused_) return std::exchange(steps_, 0);
    earned_s_ += std::chrono::duration<double>(passed).count() * speed_;
    const int due = std::min(kMostTicksPerFrame, static_cast<int>(earned_s_ / step_s));
    earned_s_ = std::min(earned_s_ - due * step_s, step_s);
    return due;
  }

  /// How far the wall clock has come from the last tick to the next one, 0 to 1.
  double Blend(double step_s) const { return paused_ ? 1 : std::clamp(earned_s_ / step_s, 0.0, 1.0); }
  bool paused() const { return paused_; }
  double speed() const { return speed_; }
  bool quit() const { return quit_; }

 private:
  static double NextFaster(double speed) {
    const double* next = std::upper_bound(std::begin(kSpeeds), std::end(kSpeeds), speed);
    return next == std::end(kSpeeds) ? speed : *next;
  }
  static double NextSlower(double speed) {
    const double* next = std::lower_bound(std::begin(kSpeeds), std::end(kSpeeds), speed);
    return next == std::begin(kSpeeds) ? speed : *(next - 1);
  }

  double speed_;
  bool paused_ = false;
  bool quit_ = false;
  int steps_ = 0;
  double earned_s_ = 0;
  Clock::time_point last_ = Clock::now();
};

/// A time that is smoothed over the last second or so, in microseconds.
class SmoothTime {
 public:
  void Add(Clock::duration passed) {
    const double us = std::chrono::duration<double, std::micro>(passed).count();
    us_ = us_ == 0 ? us : us_ + (us - us_) * 0.05;
  }
  double us() const { return us_; }

 private:
  double us_ = 0;
};

void DeliverInput(viewer::Viewer& viewer, sim::Simulation& simulation) {
  world::World& world = simulation.world();
  world.SetScreenSize(viewer.width(), viewer.height());
  const world::CameraSnapshot camera = viewer.Camera();
  world.camera().FollowViewer(camera.position, camera.orientation);
  for (const viewer::InputEvent& event : viewer.TakeEvents()) {
    if (event.kind == viewer::InputKind::kKey) simulation.Key(event.name, event.pressed);
    if (event.kind == viewer::InputKind::kMouseButton) simulation.MouseButton(event.name, event.pressed);
  }
}

int Fail(const Diagnostic& problem) {
  std::cerr << Format(problem);
  return kCannotStart;
}

/// Runs to the moment asked for without drawing, then draws it.
int TakePicture(RunSession& session, viewer::Viewer& viewer, const RunOptions& options) {
  sim::Simulation& simulation = session.simulation();
  while (!WasInterrupted() && simulation.time_s() < options.screenshot_at_s) session.Tick();
  viewer.SetStatus({.paused = false, .speed = options.speed.value_or(1), .message = {}});
  viewer.Show(simulation.Snapshot());
  if (!viewer.RenderFrame()) return session.Finish();
  if (const Result<void> saved = viewer.SaveScreenshot(options.screenshot); !saved) return Fail(saved.error());
  return session.Finish();
}

int RunLive(RunSession& session, viewer::Viewer& viewer, const RunOptions& options) {
  sim::Simulation& simulation = session.simulation();
  const double step_s = simulation.world().settings().step_s;
  Pace pace(options.speed.value_or(1));
  SmoothTime frame_time, tick_time;
  Clock::time_point frame_start = Clock::now();
  world::SceneSnapshot newest = simulation.Snapshot();
  world::SceneSnapshot previous = newest;
  while (!session.IsOver() && !pace.quit()) {
    viewer.SetStatus({.paused = pace.paused(), .speed = pace.speed(), .message = {}});
    viewer.Show(newest, &previous, pace.Blend(step_s));
    if (!viewer.RenderFrame()) break;
    frame_time.Add(Clock::now() - std::exchange(frame_start, Clock::now()));
    for (const viewer::ViewerCommand command : viewer.TakeCommands()) pace.Obey(command);
    DeliverInput(viewer, simulation);
    const int due = pace.TicksDue(step_s);
    for (int i = 0; i < due && !session.IsOver(); ++i) {
      const Clock::time_point tick_start = Clock::now();
      session.Tick();
      tick_time.Add(Clock::now() - tick_start);
      previous = std::exchange(newest, simulation.Snapshot());
    }
    if (due == 0) session.Idle();
    if (frame_time.us() > 0) simulation.ReportTimes(frame_time.us(), tick_time.us());
  }
  return session.Finish();
}

}  // namespace

int RunWindow(RunSession& session, const RunOptions& options, const sim::DataFolders& data) {
  viewer::ViewerOptions window;
  window.width = options.width_px;
  window.height = options.height_px;
  window.title = "Soarbox: " + options.scenario;
  window.media_dir = data.media;
  window.hidden = !options.screenshot.empty();
  window.vsync = !window.hidden;
  window.on_diagnostic = [](const Diagnostic& diagnostic) { std::cerr << Format(diagnostic); };
  Result<std::unique_ptr<viewer::Viewer>> viewer = viewer::Viewer::Open(window);
  if (!viewer) return Fail(viewer.error());
  return options.screenshot.empty() ? RunLive(session, **viewer, options) : TakePicture(session, **viewer, options);
}

}  // namespace soarbox::app
