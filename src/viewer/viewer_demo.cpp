// SPDX-License-Identifier: BSD-2-Clause
/// A developer's tool: shows a hand-made, moving scene in the window, without a world behind it.
///
///   viewer_demo [--screenshot FILE] [--at SECONDS] [--agents N] [--view NUMBER] [--sky NAME] ...

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numbers>

#include "viewer/demo_scene.h"
#include "viewer/viewer.h"

namespace {

using soarbox::viewer::DemoScene;
using soarbox::viewer::RunStatus;
using soarbox::viewer::Viewer;
using soarbox::viewer::ViewerCommand;

struct Arguments {
  std::string screenshot, sky;
  double at_s = 3;
  int agents = 6;
  int view = 0;
  int frames = 0;
  bool hidden = false, help = false, select = false;
};

bool Parse(int argc, char** argv, Arguments& out) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? argv[++i] : ""; };
    if (word == "--screenshot")
      out.screenshot = value();
    else if (word == "--sky")
      out.sky = value();
    else if (word == "--at")
      out.at_s = std::atof(value());
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

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  if (!Parse(argc, argv, arguments)) {
    std::fprintf(stderr,
                 "usage: viewer_demo [--screenshot FILE.png] [--at SECONDS] [--agents N] [--view 0..3] [--frames N]\n"
                 "                   [--sky NAME] [--hidden] [--help-panel] [--select]\n");
    return 2;
  }
  soarbox::viewer::ViewerOptions options;
  options.title = "Soarbox viewer demo";
  options.hidden = arguments.hidden;
  options.show_help = arguments.help;
  options.on_diagnostic = [](const soarbox::Diagnostic& d) { std::fputs(soarbox::Format(d).c_str(), stderr); };
  auto viewer = Viewer::Open(options);
  if (!viewer) {
    std::fputs(soarbox::Format(viewer.error()).c_str(), stderr);
    return 1;
  }

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
