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
#include "viewer/input_event.h"
#include "viewer/panels/layout.h"
#include "viewer/viewer_command.h"
#include "workbench/contents.h"
#include "workbench/requests.h"
#include "world/overlay_snapshot.h"
#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// How much work goes into each pixel.
enum class Detail : std::uint8_t {
  kAuto,  ///< Full, but low for a visible window on a software renderer.
  kLow,   ///< Coarser shadows, no reflections, no smoothed edges.
  kFull,
};

/// How the window opens.
struct ViewerOptions {
  int width = 1280, height = 720;  ///< Of the picture, in pixels; at least 64 by 64.
  std::string title = "Soarbox";
  std::filesystem::path media_dir = {};  ///< Holds `shaders/`; empty: ../share/soarbox/media beside the
                                         ///< program, or where the build had it.
  bool hidden = false;                   ///< Draws without a visible window (it still needs a display), for pictures.
  Detail detail = Detail::kAuto;
  /// The scene is drawn in this share of the picture's width and height, 0.5 to 1, and brought up to it; texts and
  /// panels are not. 0: in full, but three quarters for a visible window in low detail, and what thirty frames per
  /// second take if Detail::kAuto found a software renderer. Pictures are saved in full unless it is said here.
  double render_scale = 0;
  bool vsync = true;
  bool show_labels = true;    ///< Names above agents at the start (L toggles).
  bool show_help = false;     ///< The list of keys at the start (H toggles).
  bool frame_agents = false;  ///< Opens on all agents, unless the scripts' camera shows all of them, large enough.
  bool show_status_bar = true;
  std::optional<Layout> layout = {};     ///< Menus and panels around the picture; none: the picture alone.
  std::filesystem::path ui_script = {};  ///< Plays a user (panels/ui_script.h); empty: none.
  std::size_t ui_script_from = 0;        ///< So many of its steps another window has done.
  std::string log_file = {};             ///< The renderer's log; empty: none is written.
  /// Hears of what is missing and had to be replaced, once per name, and of a renderer that fails.
  std::function<void(const Diagnostic&)> on_diagnostic = {};
};

/// What the status bar says about the run; the application owns the clock.
struct RunStatus {
  bool paused = false;
  double speed = 1;     ///< Simulated seconds per second that the user asked for; infinite: as fast as it goes.
  std::string message;  ///< A short remark, "recording to run.rec"; may be empty.
};

/// A figure that is not there, drawn translucent with its name: where somebody would be in another future.
struct Ghost {
  std::string name;
  std::uint32_t agent_id = 0;  ///< Whose figure it is: a dashed line leads to where that one is; 0: nobody's.
  world::Vec3 position;        ///< Of the middle of the body, as in AgentSnapshot.
  world::Vec3 forward{0, 0, 1};
  world::Color color{0.75f, 0.85f, 1, 1};
  float opacity = 0.6f;  ///< 0..1
  float radius_m = 0.35f, height_m = 1.75f;
  bool is_name_only = false;  ///< Nothing is drawn but its name.
};

/// What frames have cost the thread that draws, in seconds of processor time, and what the last one handed to the
/// renderer, shadow maps included. For benchmarks.
struct FrameCosts {
  std::uint64_t frames = 0;
  double show_s = 0;    ///< Show: entities, poses between two ticks.
  double bodies_s = 0;  ///< Vertices of bodies follow their bones.
  double marks_s = 0;   ///< Overlays, lines, ghosts.
  double panels_s = 0;  ///< Labels and panels.
  double draw_s = 0;    ///< The renderer; where the processor draws, most of it is other threads' work.
  std::size_t draw_calls = 0, triangles = 0;
};

/// Width and height in px that the display has for windows, without its own bars; nothing if there is no display.
std::optional<std::pair<int, int>> RoomOnDisplay();

/// How far the script that plays a user has come.
struct UiScriptProgress {
  bool is_over = true;  ///< Or none was given.
  std::size_t steps_done = 0;
  std::optional<Diagnostic> failure;  ///< What went wrong with it.
};

/// The window: it shows the newest snapshot of a world and reports what the user does.
///
/// One viewer at a time per process, used by the thread that opened it. It never changes the world: keys and mouse
/// events come out as a list for the scripts, and what the user asks of the run as commands for the application.
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

  /// Hands over the newest snapshot. With the one before it and a blend from 0 (previous) to 1 (newest), bodies are
  /// drawn between the two, so that a world of 30 ticks per second looks smooth at any frame rate. Call it each frame.
  void Show(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous = nullptr, double blend = 1);

  void SetStatus(const RunStatus& status);

  /// What overlays draw besides the scene; stays until the next call. Never called: what needs it is not drawn and
  /// the keys that switch it say so (a recording does not hold it).
  void ShowOverlays(const world::OverlaySnapshot& overlays);
  /// What ShowOverlays should bring along for the overlays that are on.
  world::OverlayWants overlay_wants() const;

  /// Shows a remark in the picture for some seconds.
  void Tell(std::string text);

  /// Figures of another future, drawn until the next call; an empty list takes them away.
  /// With what the selected agent imagines.
  void SetGhosts(std::vector<Ghost> ghosts, std::vector<debugger::SceneShape> imagined = {},
                 debugger::AnswerLines answer = {});

  /// Carries out a command as its key does: at once if it is the window's, else it comes out of TakeCommands.
  void Do(ViewerCommand command);
  /// Whether an overlay is on, a camera in use, the list of keys shown; false for other commands.
  bool IsOn(ViewerCommand command) const;

  const FrameCosts& costs() const;
  /// The share of the picture's width and height that the scene is drawn in now.
  double render_scale() const;

  /// Draws one frame and reads the user's input; false once the window was closed or can no longer be drawn.
  bool RenderFrame();

  /// What happened since the last call, in order. All keys are here, also those that the window itself uses.
  std::vector<InputEvent> TakeEvents();
  std::vector<ViewerCommand> TakeCommands();

  /// What the panels show, for the application to fill in; see panel_visible.
  workbench::Contents& panel_contents();
  /// What the user asked for in panels, in order.
  std::vector<workbench::Request> TakePanelRequests();
  /// Whether a panel is in front of its area: the others need no contents.
  bool panel_visible(workbench::PanelId panel) const;
  /// Opens a panel and brings it to the front.
  void ShowPanel(workbench::PanelId panel);
  /// Opens a panel behind the others of its area, if it is not open.
  void OfferPanel(workbench::PanelId panel);
  /// As the user has arranged it, to be remembered.
  const Layout& layout() const;
  UiScriptProgress ui_script() const;

  /// Where the user looks from now; scripts ask for it (Sandbox.GetCameraPosition and its siblings).
  world::CameraSnapshot Camera() const;

  /// The size of the scene's picture in pixels, without the panels around it; scripts place their own panels by it.
  /// Changes when the user resizes the window or moves a border.
  int width() const;
  int height() const;

  /// Selects an agent as a click on it would, or none with id 0.
  void SelectAgent(std::uint32_t agent_id);
  /// The first of selection(), which panels are about; 0: none.
  std::uint32_t selected_agent() const;
  /// All that the user has selected.
  const std::vector<std::uint32_t>& selection() const;

  /// Draws the current scene once more and writes it as a PNG.
  Result<void> SaveScreenshot(const std::filesystem::path& path);

 private:
  struct Impl;
  explicit Viewer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace soarbox::viewer
