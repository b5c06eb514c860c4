// SPDX-License-Identifier: BSD-2-Clause
#include "app/window/run_window.h"

#include <chrono>
#include <thread>

#include "app/exit_codes.h"
#include "app/refuse.h"
#include "app/window/live_window.h"
#include "app/window/window_desk.h"
#include "app/window/window_options.h"
#include "diagnostics/nearest_hint.h"
#include "diagnostics/problem.h"
#include "viewer/viewer.h"
#include "workbench/recent.h"
#include "world/world.h"

namespace soarbox::app {

namespace {

/// Applies the options of the command line; an unknown word is reported with the known ones.
Result<void> Prepare(viewer::Viewer& viewer, const sim::Simulation& simulation, const RunOptions& options) {
  const auto find = [](const std::string& word, viewer::CommandGroup group,
                       const char* option) -> Result<viewer::ViewerCommand> {
    std::vector<std::string_view> words;
    for (const viewer::CommandInfo& info : viewer::Commands()) {
      if (info.group != group || info.word.empty()) continue;
      if (info.word == word) return info.command;
      words.push_back(info.word);
    }
    const std::string near = NearestHint(word, words);
    std::string hint = near.empty() ? "it is one of" : near + " It is one of";
    for (const std::string_view known : words) hint += " " + std::string(known);
    return NewProblem(std::string(option) + " knows no '" + word + "'", std::move(hint));
  };
  viewer.ShowOverlays(simulation.Overlays({}));
  const world::SceneSnapshot scene = simulation.Snapshot();
  viewer.Show(scene);
  if (!options.select.empty()) {
    std::vector<std::string_view> names;
    for (const world::AgentSnapshot& agent : scene.agents) {
      names.push_back(agent.name);
      if (agent.name == options.select) viewer.SelectAgent(agent.id);
    }
    if (viewer.selected_agent() == 0)
      return NewProblem("there is no agent '" + options.select + "' to select", NearestHint(options.select, names));
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

/// Runs to the requested time without drawing, then draws the picture.
int TakePicture(RunSession& session, viewer::Viewer& viewer, workbench::PanelExchange& panels, const WindowRun& run,
                const RunOptions& options) {
  sim::Simulation& simulation = session.simulation();
  workbench::Pace pace(options.speed.value_or(1));
  LessonDesk lessons(run.scenario, session.lesson());
  WindowDesk window_desk(viewer, panels, pace, &lessons);
  std::optional<workbench::Desk> desk;
  if (!options.panels.empty()) desk.emplace(session, run.header, run.scenario, run.settings, window_desk);
  if (desk) simulation.Submit(sim::ScreenInput{viewer.width(), viewer.height()});
  // Trails are noted for this time before the picture.
  constexpr double kWatched_s = 20;
  while (!WasInterrupted() && simulation.time_s() < options.screenshot_at_s) {
    if (simulation.time_s() > options.screenshot_at_s - kWatched_s) viewer.Show(simulation.Snapshot());
    if (desk) {
      desk->Prepare();
      // The selected agent is recorded in detail.
      simulation.NoteMind(options.select, sim::MindDetail::kAll);
    }
    session.Tick();
  }
  viewer.SetStatus({.paused = false, .speed = options.speed.value_or(1)});
  viewer.Show(simulation.Snapshot());
  viewer.ShowOverlays(simulation.Overlays(viewer.overlay_wants()));
  // Draws several frames: panels request their contents in one frame and show them in a later one.
  const int frames = desk ? 16 : 3;
  for (int i = 0; i < frames; ++i) {
    if (desk) {
      window_desk.Serve(*desk);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (!viewer.RenderFrame()) return session.Finish();
  }
  if (const Result<void> saved = viewer.SaveScreenshot(options.screenshot); !saved) return Refuse(saved.error());
  return session.Finish();
}

}  // namespace

int RunWindow(RunSession& session, const RunOptions& options, const sim::DataFolders& data, const WindowRun& run) {
  Result<viewer::ViewerOptions> window = WindowOptionsOf(options, data, !options.screenshot.empty());
  if (!window) return Refuse(window.error());
  window->width = run.settings.screen_width_px;
  window->height = run.settings.screen_height_px;
  window->title = "Soarbox: " + options.scenario;
  workbench::PanelExchange panels;
  window->panels = &panels;
  Result<std::unique_ptr<viewer::Viewer>> opened = viewer::Viewer::Open(*window);
  if (!opened) return Refuse(opened.error());
  viewer::Viewer& viewer = **opened;
  if (const Result<void> prepared = Prepare(viewer, session.simulation(), options); !prepared)
    return Refuse(prepared.error());
  if (window->hidden) return TakePicture(session, viewer, panels, run, options);
  workbench::NoteRecentRun(options.scenario);
  return AfterWindow(viewer, options, LiveWindow(session, viewer, panels, run, options).Run());
}

}  // namespace soarbox::app
