// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <utility>

#include "app/recording_commands.h"
#include "app/run_options.h"
#include "app/run_session.h"
#include "record/export.h"
#include "record/header.h"
#include "record/reader.h"
#include "sim/scenario.h"

namespace soarbox::app {

/// What a run was made from, so that a window can make it again; kept up to date when it begins again.
struct WindowRun {
  const sim::Scenario& scenario;
  const sim::SimulationSettings& settings;
  const record::Header& header;
};

/// Shows runs and recordings. Two programs carry out the same commands: soarbox-window has a window; soarbox has none,
/// loads none of its libraries, and starts in half the time. Where a command needs a window, soarbox goes on as
/// soarbox-window.
class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  virtual ~Window() = default;

  /// Whether there is something to open it on.
  [[nodiscard]] virtual bool CanOpen() const;
  /// Width and height in px of what the display has room for; none: it does not say.
  [[nodiscard]] virtual std::optional<std::pair<int, int>> RoomOnDisplay() const = 0;
  /// Runs until the window is closed, the time is up or the screenshot is taken. Returns an ExitCode.
  virtual int Run(RunSession& session, const RunOptions& options, const sim::DataFolders& data,
                  const WindowRun& run) const = 0;
  /// Shows a recording, forwards and backwards, with the panels of a run around it; returns an ExitCode once the window
  /// has closed.
  virtual int Replay(record::Reader& recording, record::TickRange range, const sim::DataFolders& data,
                     const RecordingOptions& options) const = 0;
};

/// The window of this program; null: it has none.
const Window* ProgramWindow();
/// Whether it has one that can be opened.
bool CanOpenWindow();
/// Gives the program its window; null, or what lives as long as the program.
void SetProgramWindow(const Window* window);

/// Whether there is a display to open a window on.
bool HasDisplay();

/// Goes on as the program soarbox-window in the same folder, with the same arguments. Returns where this program has a
/// window itself, there is no display, or no such program can be started.
void GoOnInWindow(char** argv);
/// For soarbox-window: where soarbox went on as this program, recordings of either are of one build.
void BeThatBuild();

/// Width and height of a window in px.
struct WindowSize {
  int width = 1280, height = 720;
};
/// What was asked for. If nothing was, a window for somebody to look at takes most of the display, and a picture or a
/// window that a script uses has the same size everywhere.
WindowSize WindowSizeOf(const RunOptions& options);

}  // namespace soarbox::app
