// SPDX-License-Identifier: BSD-2-Clause
/// A developer's tool: measures the cost of frames of a scenario.
///
///   viewer_demo --scenario FOLDER_OR_FILE [--at SECONDS] [--frames N] [--full] [--render-scale SHARE]
///               [--screenshot FILE]

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <utility>

#include "sim/simulation.h"
#include "viewer/viewer.h"

namespace {

using soarbox::viewer::Viewer;

struct Arguments {
  std::string screenshot, scenario;
  double at_s = 3, render_scale = 0;
  int frames = 40;
  bool full = false;
};

bool Parse(int argc, char** argv, Arguments& out) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : ""; };
    if (word == "--screenshot")
      out.screenshot = value();
    else if (word == "--scenario")
      out.scenario = value();
    else if (word == "--full")
      out.full = true;
    else if (word == "--at")
      out.at_s = std::atof(value());
    else if (word == "--render-scale")
      out.render_scale = std::atof(value());
    else if (word == "--frames")
      out.frames = std::atoi(value());
    else
      return false;
  }
  return !out.scenario.empty();
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
  const int frames = arguments.frames;
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
                 "usage: viewer_demo --scenario FOLDER_OR_FILE [--at SECONDS] [--frames N] [--full]\n"
                 "                   [--render-scale 0.5..1] [--screenshot FILE.png]\n");
    return 2;
  }
  soarbox::viewer::ViewerOptions options;
  options.title = "Soarbox viewer demo";
  options.frame_agents = true;
  options.render_scale = arguments.render_scale;
  if (arguments.full) options.detail = soarbox::viewer::Detail::kFull;
  options.vsync = false;
  options.on_diagnostic = [](const soarbox::Diagnostic& d) { std::fputs(soarbox::Format(d).c_str(), stderr); };
  auto viewer = Viewer::Open(options);
  if (!viewer) {
    std::fputs(soarbox::Format(viewer.error()).c_str(), stderr);
    return 1;
  }
  return Measure(**viewer, arguments);
}
