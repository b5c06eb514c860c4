// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "viewer/frame_meter.h"
#include "viewer/input_reader.h"
#include "viewer/labels.h"
#include "viewer/panel_host.h"
#include "viewer/panels/panel_input.h"
#include "viewer/panels/panel_layout.h"
#include "viewer/panels/ui_script.h"
#include "viewer/render_engine.h"

namespace soarbox::viewer {

/// Connects the workspace to the window: passes it its share of the input, places the scene next to the panels, and
/// moves overlays to the scene's place.
///
/// The drawing of the scene does not depend on this: its picture begins at 0, 0.
class WorkspaceHost {
 public:
  WorkspaceHost(Engine& engine, PanelHost& host, workbench::PanelExchange& panels, const Layout& layout);

  /// Loads a script that plays a user and starts at step `from`.
  Result<void> LoadScript(const std::filesystem::path& file, std::size_t from);
  /// Applies the layout's text size and picture. Call it before the input of a frame is read.
  void PlacePicture();
  InputClaims Claims();
  /// Passes the input to the panels. Call it after the input was read.
  void ApplyInput() { input_.Apply(); }

  /// Drawing over the scene between these two calls is moved and clipped to the scene's place.
  void BeginPicture();
  void EndPicture();

  struct Asked {
    std::uint32_t selected = 0;
    std::vector<ViewerCommand> commands;
  };
  Asked Draw(const world::SceneSnapshot& scene, const RunStatus& status, std::uint32_t selected,
             float frames_per_second, const std::function<bool(ViewerCommand)>& is_on);
  /// The contents of a frame, for the script that plays a user.
  struct Drawn {
    const world::SceneSnapshot& scene;
    world::CameraSnapshot camera;
    Projection view;
    std::span<const ShownLabel> labels;
    std::uint32_t selected = 0;
    std::function<std::uint32_t(ScreenPoint)> agent_at;  ///< The agent that a click there would select; 0: none.
    std::function<Result<void>(const std::filesystem::path&)> save_picture;
  };
  /// Advances the script.
  void AfterDrawing(const Drawn& drawn);

  Layout& layout() { return workspace_.layout; }
  const Layout& layout() const { return workspace_.layout; }
  bool& show_help() { return workspace_.show_help; }
  bool show_help() const { return workspace_.show_help; }
  /// Whether the window may close now; else the user is asked first.
  bool MayClose() { return workspace_.MayClose(panels_.contents); }
  UiScriptProgress script() const;

 private:
  bool TakeShortcut(const SDL_Event& event);
  /// Returns a point of the window where a click selects exactly this agent; nothing if there is none.
  std::optional<ImVec2> PlaceOf(const Drawn& drawn, const std::string& agent) const;
  /// Esc closes the window only when it is pressed twice, because the first press may have been meant for a field or a
  /// menu.
  bool IsSecondEscape();

  Engine& engine_;
  PanelHost& host_;
  workbench::PanelExchange& panels_;
  Workspace workspace_;
  PanelInput input_;
  PictureRect picture_;
  std::chrono::steady_clock::time_point escaped_at_;
  std::optional<UiScript> script_;
  FrameMeter meter_;
};

}  // namespace soarbox::viewer
