// SPDX-License-Identifier: BSD-2-Clause
#include "app/run_window.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <utility>

#include "app/exit_codes.h"
#include "app/pace.h"
#include "app/run_control.h"
#include "viewer/viewer.h"
#include "world/world.h"

namespace soarbox::app {

const bool kHasWindow = true;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRemarkShown_s = 6;

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

/// Sends what the user did through the simulation's door.
void SubmitEvent(const viewer::InputEvent& event, sim::Simulation& simulation) {
  const auto x = static_cast<float>(event.x), y = static_cast<float>(event.y);
  switch (event.kind) {
    case viewer::InputKind::kKey:
      simulation.Submit(sim::KeyInput{event.name, event.pressed});
      break;
    case viewer::InputKind::kMouseButton:
      simulation.Submit(sim::ButtonInput{event.name, event.pressed, x, y});
      break;
    case viewer::InputKind::kMouseMove:
      if (event.wheel != 0) simulation.Submit(sim::WheelInput{static_cast<float>(event.wheel), x, y});
      if (event.dx != 0 || event.dy != 0)
        simulation.Submit(sim::PointerInput{x, y, static_cast<float>(event.dx), static_cast<float>(event.dy)});
      break;
  }
}

/// Sends the window's size, the camera's pose and the user's events; the first two if they changed.
class Deliverer {
 public:
  void Deliver(viewer::Viewer& viewer, sim::Simulation& simulation) {
    const world::World& world = std::as_const(simulation).world();
    const sim::ScreenInput screen{viewer.width(), viewer.height()};
    if (screen != screen_) simulation.Submit(screen);
    screen_ = screen;
    const world::CameraSnapshot pose = viewer.Camera();
    const sim::CameraInput camera{pose.position, pose.orientation};
    const world::CameraSnapshot& known = world.camera().state();
    if (camera != camera_ && camera != sim::CameraInput{known.position, known.orientation}) simulation.Submit(camera);
    camera_ = camera;
    for (const viewer::InputEvent& event : viewer.TakeEvents()) SubmitEvent(event, simulation);
  }

 private:
  sim::ScreenInput screen_;
  sim::CameraInput camera_;
};

/// What a frame and a tick take, for the status bar.
std::string CostText(const SmoothTime& frame, const SmoothTime& tick) {
  if (tick.us() == 0) return {};
  char text[64];
  std::snprintf(text, sizeof text, "frame %.1f ms, tick %.1f ms", frame.us() / 1000, tick.us() / 1000);
  return text;
}

int Fail(const Diagnostic& problem) {
  std::cerr << Format(problem);
  return kCannotStart;
}

/// Turns on what the command line asks for; a word that means nothing is told with those that do.
Result<void> Prepare(viewer::Viewer& viewer, const world::SceneSnapshot& scene, const RunOptions& options) {
  const auto find = [](const std::string& word, viewer::CommandGroup group,
                       const char* option) -> Result<viewer::ViewerCommand> {
    std::vector<std::string_view> words;
    for (const viewer::CommandInfo& info : viewer::Commands()) {
      if (info.group != group || info.word.empty()) continue;
      if (info.word == word) return info.command;
      words.push_back(info.word);
    }
    Diagnostic problem;
    problem.message = std::string(option) + " knows no '" + word + "'";
    const std::string_view near = Suggest(word, words);
    problem.hint = near.empty() ? "it is one of" : "did you mean '" + std::string(near) + "'? It is one of";
    for (const std::string_view known : words) problem.hint += " " + std::string(known);
    return problem;
  };
  viewer.Show(scene);
  if (!options.select.empty()) {
    std::vector<std::string_view> names;
    for (const world::AgentSnapshot& agent : scene.agents) {
      names.push_back(agent.name);
      if (agent.name == options.select) viewer.SelectAgent(agent.id);
    }
    if (viewer.selected_agent() == 0) {
      Diagnostic problem;
      problem.message = "there is no agent '" + options.select + "' to select";
      if (const std::string_view near = Suggest(options.select, names); !near.empty())
        problem.hint = "did you mean '" + std::string(near) + "'?";
      return problem;
    }
  }
  for (const std::string& word : options.show) {
    const Result<viewer::ViewerCommand> overlay = find(word, viewer::CommandGroup::kOverlay, "--show");
    if (!overlay) return overlay.error();
    if (!viewer.IsOn(*overlay)) viewer.Do(*overlay);
  }
  if (options.camera.empty()) return {};
  const Result<viewer::ViewerCommand> camera = find(options.camera, viewer::CommandGroup::kCamera, "--camera");
  if (!camera) return camera.error();
  viewer.Do(*camera);
  return {};
}

/// Runs to the moment asked for without drawing, then draws it.
int TakePicture(RunSession& session, viewer::Viewer& viewer, const RunOptions& options) {
  sim::Simulation& simulation = session.simulation();
  // Trails want to have been watched for a while.
  constexpr double kWatched_s = 20;
  while (!WasInterrupted() && simulation.time_s() < options.screenshot_at_s) {
    if (simulation.time_s() > options.screenshot_at_s - kWatched_s) viewer.Show(simulation.Snapshot());
    session.Tick();
  }
  viewer.SetStatus({.paused = false, .speed = options.speed.value_or(1), .message = options.remark});
  viewer.Show(simulation.Snapshot());
  viewer.ShowOverlays(simulation.Overlays(viewer.overlay_wants()));
  if (options.camera.empty()) viewer.Do(viewer::ViewerCommand::kFrameAll);
  // The camera is a moment on its way to where the agents are by now.
  constexpr auto kOnTheWay = std::chrono::milliseconds(1500);
  for (const Clock::time_point begin = Clock::now(); Clock::now() - begin < kOnTheWay;)
    if (!viewer.RenderFrame()) return session.Finish();
  if (const Result<void> saved = viewer.SaveScreenshot(options.screenshot); !saved) return Fail(saved.error());
  return session.Finish();
}

int RunLive(RunSession& session, viewer::Viewer& viewer, const RunOptions& options) {
  const double step_s = static_cast<double>(std::as_const(session.simulation()).world().settings().step_s);
  Pace pace(options.speed.value_or(1));
  Deliverer deliverer;
  SmoothTime frame_time, tick_time;
  Clock::time_point frame_start = Clock::now();
  world::SceneSnapshot newest = session.simulation().Snapshot();
  world::SceneSnapshot previous = newest;
  std::uint64_t overlays_tick = ~std::uint64_t{0};
  world::OverlayWants overlay_wants;
  while (!session.IsOver() && !pace.quit()) {
    // Where the recording goes is said at first.
    const bool says_remark = !options.remark.empty() && newest.time_s < kRemarkShown_s;
    viewer.SetStatus({.paused = pace.paused(),
                      .speed = pace.speed(),
                      .message = says_remark ? options.remark : CostText(frame_time, tick_time)});
    viewer.Show(newest, &previous, pace.Blend(step_s));
    if (const world::OverlayWants wants = viewer.overlay_wants();
        newest.tick != overlays_tick || wants != overlay_wants) {
      viewer.ShowOverlays(session.simulation().Overlays(wants));
      overlays_tick = newest.tick;
      overlay_wants = wants;
    }
    if (!viewer.RenderFrame()) break;
    frame_time.Add(Clock::now() - std::exchange(frame_start, Clock::now()));
    RunControl control;
    for (const viewer::ViewerCommand command : viewer.TakeCommands()) {
      pace.Obey(command);
      const Result<bool> obeyed = control.Obey(command, session, viewer, newest);
      if (!obeyed) return Fail(obeyed.error());
    }
    if (control.has_begun_again) {
      newest = previous = session.simulation().Snapshot();
      overlays_tick = ~std::uint64_t{0};
      deliverer = Deliverer();
      pace.Skip();
    }
    deliverer.Deliver(viewer, session.simulation());
    const int due = pace.TicksDue(step_s);
    bool is_cut = false;
    for (int i = 0; i < due && !is_cut && !session.IsOver(); ++i) {
      const Clock::time_point tick_start = Clock::now();
      session.Tick();
      tick_time.Add(Clock::now() - tick_start);
      is_cut = pace.OutOfTime();
      // Only the last two are drawn.
      if (i + 2 >= due && !is_cut) previous = std::exchange(newest, session.simulation().Snapshot());
    }
    if (is_cut) previous = newest = session.simulation().Snapshot();
    if (due == 0) session.Idle();
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
  window.frame_agents = true;
  window.vsync = !window.hidden;
  window.detail = options.detail == "low"    ? viewer::Detail::kLow
                  : options.detail == "full" ? viewer::Detail::kFull
                                             : viewer::Detail::kAuto;
  window.on_diagnostic = [](const Diagnostic& diagnostic) { std::cerr << Format(diagnostic); };
  Result<std::unique_ptr<viewer::Viewer>> viewer = viewer::Viewer::Open(window);
  if (!viewer) return Fail(viewer.error());
  if (const Result<void> prepared = Prepare(**viewer, session.simulation().Snapshot(), options); !prepared)
    return Fail(prepared.error());
  return options.screenshot.empty() ? RunLive(session, **viewer, options) : TakePicture(session, **viewer, options);
}

}  // namespace soarbox::app
