// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "viewer/panels/layout.h"
#include "viewer/viewer_command.h"
#include "viewer/window_input.h"
#include "workbench/panel_exchange.h"
#include "world/overlay_snapshot.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// The amount of work per pixel.
enum class Detail : std::uint8_t {
  kAuto,  ///< Full, but low for a visible window on a software renderer.
  kLow,   ///< Coarser shadows, no reflections, no antialiasing.
  kFull,
};

/// Options of the window.
struct ViewerOptions {
  int width = 1280, height = 720;  ///< Of the picture, in pixels; at least 64 by 64.
  std::string title = "Soarbox";
  std::filesystem::path media_dir =
      {};  ///< Contains `shaders/`; empty: ../share/soarbox/media next to the program, or the folder of the build.
  bool hidden = false;  ///< Draws without a visible window (it still needs a display), for pictures.
  Detail detail = Detail::kAuto;
  /// The scene is drawn with this fraction of the picture's width and height, 0.5 to 1, and enlarged. Texts and panels
  /// keep their resolution. 0: full size, but three quarters for a visible window in low detail, and a scale with
  /// thirty frames per second if Detail::kAuto found a software renderer. Pictures in files are full size unless this
  /// is set.
  double render_scale = 0;
  bool vsync = true;
  bool show_labels = true;  ///< Names above agents at the start (L toggles).
  bool frame_agents =
      false;  ///< Starts with a view of all agents, unless the scripts' camera already shows all of them large enough.
  std::optional<Layout> layout = {};           ///< Menus and panels around the picture; none: the picture alone.
  workbench::PanelExchange* panels = nullptr;  ///< Of these panels, if there is a layout; must outlive the viewer.
  std::filesystem::path ui_script = {};        ///< Plays a user (panels/ui_script.h); empty: none.
  std::size_t ui_script_from = 0;              ///< Number of steps that another window has already executed.
  std::string log_file = {};                   ///< The renderer's log; empty: none is written.
  /// Called once per name for things that are missing and were replaced, and for a renderer that fails.
  std::function<void(const Diagnostic&)> on_diagnostic = {};
};

/// The state of the run for the toolbar. The application owns the clock.
struct RunStatus {
  bool paused = false;
  double speed = 1;          ///< Simulated seconds per second that the user requested; infinite: as fast as possible.
  std::string message = {};  ///< Of the tooltip of the clock; may be empty.
};

/// A translucent figure with a name: the place of an agent in another future, or its believed place.
struct Ghost {
  std::string name;
  std::uint32_t agent_id = 0;  ///< The agent that it represents; a dashed line leads to that agent. 0: none.
  world::Vec3 position;        ///< Of the body's centre, as in AgentSnapshot.
  world::Vec3 forward{0, 0, 1};
  world::Color color{0.75f, 0.85f, 1, 1};
  float opacity = 0.6f;  ///< 0..1
  float radius_m = 0.35f, height_m = 1.75f;
  bool is_name_only = false;  ///< Only its name is drawn.
};

/// Processor time of the drawing thread in seconds, and the draw calls and triangles of the last frame, including
/// shadow maps. For benchmarks.
struct FrameCosts {
  std::uint64_t frames = 0;
  double show_s = 0;    ///< Show: entities, poses between two ticks.
  double bodies_s = 0;  ///< Moving vertices of bodies with their bones.
  double marks_s = 0;   ///< Overlays, lines, ghosts.
  double panels_s = 0;  ///< Labels and panels.
  double draw_s = 0;    ///< The renderer; a software renderer does most of this work on other threads.
  std::size_t draw_calls = 0, triangles = 0;
};

/// Width and height in px that the display has for windows, without its own bars; nothing if there is no display.
std::optional<std::pair<int, int>> RoomOnDisplay();

/// Progress of the script that plays a user.
struct UiScriptProgress {
  bool is_over = true;  ///< Also true if no script was given.
  std::size_t steps_done = 0;
  std::optional<Diagnostic> failure;  ///< Its error, if it failed.
};

/// The window: it shows the newest snapshot of a world and reports user input.
///
/// Only one viewer may exist per process, and only the thread that opened it may use it. It never changes the world.
/// Key and mouse events come out as a list for the scripts, and requests that concern the run as commands for the
/// application.
///
///   auto viewer = Viewer::Open({.title = "Soarbox"});
///   if (!viewer) ...                       // No display, no OpenGL 3.3, no media: the diagnostic says which.
///   while ((*viewer)->RenderFrame()) {
///     ... (*viewer)->TakeEvents(), TakeCommands(), step the world ...
///     (*viewer)->Show(newest, &previous, blend);
///   }
class Viewer {
 public:
  /// Opens the window. Fails without a display (naming it), without OpenGL 3.3, or if the media folder is missing.
  static Result<std::unique_ptr<Viewer>> Open(const ViewerOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Sets the snapshot to draw. Call it for each frame. With the previous snapshot, bodies are drawn between the two:
  /// `blend` 0 is the previous one, 1 the newest. A world of 30 ticks per second then looks smooth at any frame rate.
  void Show(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous = nullptr, double blend = 1);

  void SetStatus(const RunStatus& status);

  /// Sets the data of the overlays; they stay until the next call. If it was never called, overlays that need these
  /// data are not drawn, and their keys say so (a recording does not contain the data).
  void ShowOverlays(const world::OverlaySnapshot& overlays);
  /// The data that ShowOverlays should pass for the overlays that are switched on.
  world::OverlayWants overlay_wants() const;

  /// Shows a remark in the picture for some seconds.
  void Tell(std::string text);

  /// Shows figures of another future, and the imagined scene of the selected agent, until the next call. An empty list
  /// removes them.
  void SetGhosts(std::vector<Ghost> ghosts, std::vector<debugger::SceneShape> imagined = {},
                 debugger::AnswerLines answer = {});

  /// Executes a command as its key does: at once if it concerns the window, else TakeCommands returns it.
  void Do(ViewerCommand command);
  /// Whether the command's camera mode or scale is selected, or its overlay is on. kMute: whether sounds are off.
  /// kHelp: whether the list of keys is shown. kTogglePause: whether the run is paused. kUnlimited: whether it has no
  /// speed limit. False for other commands.
  bool IsOn(ViewerCommand command) const;

  const FrameCosts& costs() const;
  /// The fraction of the picture's width and height at which the scene is currently drawn.
  double render_scale() const;

  /// Draws one frame and reads the user's input. Returns false after the window was closed, or if it can no longer be
  /// drawn.
  bool RenderFrame();

  /// Returns the events since the last call, in order. All keys are included, also those that the window itself uses.
  std::vector<InputEvent> TakeEvents();
  std::vector<ViewerCommand> TakeCommands();

  /// Whether a panel is the front one of its area. Other panels need no contents.
  bool panel_visible(workbench::PanelId panel) const;
  /// Opens a panel and brings it to the front.
  void ShowPanel(workbench::PanelId panel);
  /// If a panel is not open, adds it as the last tab of its default area. The front tab stays.
  void OfferPanel(workbench::PanelId panel);
  /// The layout as the user has arranged it, for saving.
  const Layout& layout() const;
  UiScriptProgress ui_script() const;

  /// The current camera; scripts can query it (Sandbox.GetCameraPosition and similar functions).
  world::CameraSnapshot Camera() const;

  /// The size of the scene's picture in pixels, without the panels around it. Scripts place their own panels with it.
  /// It changes when the user resizes the window or moves a border.
  int width() const;
  int height() const;

  /// Selects an agent as a click on it would, or none with id 0.
  void SelectAgent(std::uint32_t agent_id);
  /// The first agent of selection(), which panels show; 0: none.
  std::uint32_t selected_agent() const;
  /// All agents that the user has selected.
  const std::vector<std::uint32_t>& selection() const;

  /// Draws the current scene once more and writes it as a PNG.
  Result<void> SaveScreenshot(const std::filesystem::path& path);

 private:
  struct Impl;
  explicit Viewer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::viewer
