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

/// The data from which a run was created, so that a window can create it again. Updated when the run restarts.
struct WindowRun {
  const sim::Scenario& scenario;
  const sim::SimulationSettings& settings;
  const record::Header& header;
};

/// Shows runs and recordings. Two programs execute the same commands. soarbox-window has a window. soarbox has none,
/// does not load the window's libraries, and starts in half the time. If a command needs a window, soarbox starts
/// soarbox-window.
class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  virtual ~Window() = default;

  /// Whether a window can be opened.
  [[nodiscard]] virtual bool CanOpen() const;
  /// Size of the usable display area in pixels, or nothing if the display does not report it.
  [[nodiscard]] virtual std::optional<std::pair<int, int>> RoomOnDisplay() const = 0;
  /// Runs until the window is closed, the time is over or the screenshot is taken. Returns an ExitCode.
  virtual int Run(RunSession& session, const RunOptions& options, const sim::DataFolders& data,
                  const WindowRun& run) const = 0;
  /// Shows a recording, forwards and backwards, with the panels of a run around it. Returns an ExitCode after the
  /// window has closed.
  virtual int Replay(record::Reader& recording, record::TickRange range, const sim::DataFolders& data,
                     const RecordingOptions& options) const = 0;
};

/// The window of this program; null if it has none.
const Window* ProgramWindow();
/// Whether the program has a window and it can be opened.
bool CanOpenWindow();
/// Sets the program's window: null, or an object that lives as long as the program.
void SetProgramWindow(const Window* window);

/// Whether there is a display to open a window on.
bool HasDisplay();

/// Replaces this process by soarbox-window in the same folder, with the same arguments. Returns if this program has a
/// window itself, if there is no display, or if that program cannot be started.
void GoOnInWindow(char** argv);
/// For soarbox-window: if soarbox started this program, recordings of both have the same build id.
void BeThatBuild();

/// Width and height of a window in px.
struct WindowSize {
  int width = 1280, height = 720;
};
/// Returns the requested size. Otherwise a visible window takes most of the display, and a picture or a window for a
/// script has the same size everywhere.
WindowSize WindowSizeOf(const RunOptions& options);

}  // namespace soarbox::app
