// SPDX-License-Identifier: BSD-2-Clause
/// A developer's tool: shows a generated, moving scene in the window without a world, or measures the cost of frames of
/// a scenario.
///
///   viewer_demo [--screenshot FILE] [--at SECONDS] [--agents N] [--view NUMBER] [--sky NAME] ...
///   viewer_demo --scenario FOLDER_OR_FILE [--at SECONDS] [--frames N] [--full] [--render-scale SHARE]

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <numbers>
#include <utility>

#include "sim/simulation.h"
#include "viewer/demo_scene_test_support.h"
#include "viewer/viewer.h"

namespace {

using soarbox::viewer::DemoScene;
using soarbox::viewer::RunStatus;
using soarbox::viewer::Viewer;
using soarbox::viewer::ViewerCommand;

struct Arguments {
  std::string screenshot, sky, scenario;
  double at_s = 3, render_scale = 0;
  int agents = 6;
  int view = 0;
  int frames = 0;
  bool hidden = false, help = false, select = false, full = false;
};

bool Parse(int argc, char** argv, Arguments& out) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : ""; };
    if (word == "--screenshot")
      out.screenshot = value();
    else if (word == "--sky")
      out.sky = value();
    else if (word == "--scenario")
      out.scenario = value();
    else if (word == "--full")
      out.full = true;
    else if (word == "--at")
      out.at_s = std::atof(value());
    else if (word == "--render-scale")
      out.render_scale = std::atof(value());
    else if (word == "--agents")
      out.agents = std::atoi(value());
    else if (word == "--view")
      out.view = std::atoi(value());
    else if (word == "--frames")
      out.frames = std::atoi(value());
    else if (word == "--hidden")
      out.hidden = true;
    else if (word == "--help-panel")
      out.help = true;
    else if (word == "--select")
      out.select = true;
    else
      return false;
  }
  return true;
}

double ProcessSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Runs a scenario up to a time, then draws frames, four for each tick, and prints the cost of the parts of a frame.
int Measure(Viewer& viewer, const Arguments& arguments) {
  using namespace soarbox;
  const std::string root = SOARBOX_SOURCE_DIR;
  const auto scenario = sim::FindScenario(arguments.scenario, {root + "/scenarios", root + "/media"});
  if (!scenario) {
    std::fputs(Format(scenario.error()).c_str(), stderr);
    return 1;
  }
  auto made = sim::Simulation::Create(*scenario, {});
  if (!made) {
    std::fputs(Format(made.error()).c_str(), stderr);
    return 1;
  }
  sim::Simulation& simulation = **made;
  while (simulation.time_s() < arguments.at_s) {
    simulation.Tick();
    simulation.TakeEvents();
  }
  world::SceneSnapshot before = simulation.Snapshot(), now = before;
  const int frames = arguments.frames > 0 ? arguments.frames : 40;
  constexpr int kFramesPerTick = 4, kFirst = 12;
  viewer::FrameCosts start;
  double spent_s = 0, wall_s = 0;
  for (int frame = 0; frame < kFirst + frames; ++frame) {
    if (frame == kFirst) start = viewer.costs();
    if (frame % kFramesPerTick == 0) {
      simulation.Tick();
      simulation.TakeEvents();
      before = std::exchange(now, simulation.Snapshot());
      viewer.ShowOverlays(simulation.Overlays(viewer.overlay_wants()));
    }
    const double begin_s = ProcessSeconds();
    const auto begin = std::chrono::steady_clock::now();
    viewer.Show(now, &before, static_cast<double>(frame % kFramesPerTick) / kFramesPerTick);
    if (!viewer.RenderFrame()) return 1;
    if (frame < kFirst) continue;
    spent_s += ProcessSeconds() - begin_s;
    wall_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  // A hidden window draws only the pictures that it saves.
  if (!arguments.screenshot.empty()) {
    if (auto saved = viewer.SaveScreenshot(arguments.screenshot); !saved) {
      std::fputs(Format(saved.error()).c_str(), stderr);
      return 1;
    }
  }
  const viewer::FrameCosts& end = viewer.costs();
  const auto ms = [&](double seconds) { return 1000 * seconds / frames; };
  std::printf("%zu agents, %dx%d, the scene at %.0f %%: %zu draw calls, %zu triangles\n", now.agents.size(),
              viewer.width(), viewer.height(), 100 * viewer.render_scale(), end.draw_calls, end.triangles);
  std::printf("ms of processor time per frame: all threads %.2f; of the drawing thread: show %.2f, bodies %.2f, ",
              ms(spent_s), ms(end.show_s - start.show_s), ms(end.bodies_s - start.bodies_s));
  std::printf("marks %.2f, labels and panels %.2f, renderer %.2f; wall clock %.2f\n", ms(end.marks_s - start.marks_s),
              ms(end.panels_s - start.panels_s), ms(end.draw_s - start.draw_s), ms(wall_s));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  if (!Parse(argc, argv, arguments)) {
    std::fprintf(stderr,
                 "usage: viewer_demo [--screenshot FILE.png] [--at SECONDS] [--agents N] [--view 0..3] [--frames N]\n"
                 "                   [--sky NAME] [--hidden] [--help-panel] [--select]\n"
                 "       viewer_demo --scenario FOLDER_OR_FILE [--at SECONDS] [--frames N] [--full]\n"
                 "                   [--render-scale 0.5..1]\n");
    return 2;
  }
  soarbox::viewer::ViewerOptions options;
  options.title = "Soarbox viewer demo";
  options.hidden = arguments.hidden;
  options.show_help = arguments.help;
  options.frame_agents = !arguments.scenario.empty();
  options.render_scale = arguments.render_scale;
  if (arguments.full) options.detail = soarbox::viewer::Detail::kFull;
  options.vsync = arguments.scenario.empty();
  options.on_diagnostic = [](const soarbox::Diagnostic& d) { std::fputs(soarbox::Format(d).c_str(), stderr); };
  auto viewer = Viewer::Open(options);
  if (!viewer) {
    std::fputs(soarbox::Format(viewer.error()).c_str(), stderr);
    return 1;
  }

  if (!arguments.scenario.empty()) return Measure(**viewer, arguments);
  DemoScene demo(arguments.agents, arguments.view, (*viewer)->width(), (*viewer)->height());
  if (arguments.select && arguments.agents > 1) (*viewer)->SelectAgent(2);
  RunStatus status;
  double time_s = arguments.screenshot.empty() ? 0 : arguments.at_s;
  for (int frame = 1;; ++frame) {
    soarbox::world::SceneSnapshot scene = demo.At(time_s);
    if (!arguments.sky.empty()) scene.sky = arguments.sky;
    (*viewer)->Show(scene);
    (*viewer)->SetStatus(status);
    if (!(*viewer)->RenderFrame()) return 0;
    for (const ViewerCommand command : (*viewer)->TakeCommands()) {
      if (command == ViewerCommand::kTogglePause) status.paused = !status.paused;
      if (command == ViewerCommand::kQuit) return 0;
    }
    (*viewer)->TakeEvents();
    if (!arguments.screenshot.empty() && frame >= std::max(arguments.frames, 3)) break;
    if (arguments.screenshot.empty() && arguments.frames > 0 && frame >= arguments.frames) return 0;
    if (arguments.screenshot.empty() && !status.paused) time_s += 1.0 / 60;
  }
  if (auto saved = (*viewer)->SaveScreenshot(arguments.screenshot); !saved) {
    std::fputs(soarbox::Format(saved.error()).c_str(), stderr);
    return 1;
  }
  return 0;
}
