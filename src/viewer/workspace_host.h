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
#include "viewer/panels/ui_script.h"
#include "viewer/panels/workspace.h"
#include "viewer/render_engine.h"

namespace soarbox::viewer {

/// Brings the workspace into the window: gives it its share of the input, sets the scene beside the panels, and moves
/// what is drawn over the scene to where the scene stands.
///
/// The scene's own drawing knows nothing of this: for it the picture begins at 0, 0.
class WorkspaceHost {
 public:
  WorkspaceHost(Engine& engine, PanelHost& host, const Layout& layout);

  /// A script that plays a user, from this step on.
  Result<void> LoadScript(const std::filesystem::path& file, std::size_t from);
  /// Sets text size and picture as the layout wants them; before the input of a frame is read.
  void PlacePicture();
  InputClaims Claims();
  /// Hands the panels their input; after it was read.
  void ApplyInput() { input_.Apply(); }

  /// What is drawn between these two over the scene is placed and cut as the scene is.
  void BeginPicture();
  void EndPicture();

  struct Asked {
    std::uint32_t selected = 0;
    std::vector<ViewerCommand> commands;
  };
  Asked Draw(const world::SceneSnapshot& scene, const RunStatus& status, std::uint32_t selected,
             float frames_per_second, const std::function<bool(ViewerCommand)>& is_on);
  /// What a frame showed, for the script that plays a user.
  struct Drawn {
    const world::SceneSnapshot& scene;
    world::CameraSnapshot camera;
    Projection view;
    std::span<const ShownLabel> labels;
    std::uint32_t selected = 0;
    std::function<std::uint32_t(ScreenPoint)> agent_at;  ///< Whom a click there would select; 0: nobody.
    std::function<Result<void>(const std::filesystem::path&)> save_picture;
  };
  /// Lets the script go on.
  void AfterDrawing(const Drawn& drawn);

  workbench::Contents contents;
  std::vector<workbench::Request> requests;
  Layout& layout() { return workspace_.layout; }
  const Layout& layout() const { return workspace_.layout; }
  bool& show_help() { return workspace_.show_help; }
  /// The user has asked to close the list of keys; once.
  bool TakeClosesHelp() { return std::exchange(closes_help_, false); }
  /// Whether the window may close now; else the user is asked first.
  bool MayClose() { return workspace_.MayClose(contents); }
  UiScriptProgress script() const;

 private:
  bool TakeShortcut(const SDL_Event& event);
  /// Where in the window a click selects this agent and nobody else; none if nothing of it can be clicked.
  std::optional<ImVec2> PlaceOf(const Drawn& drawn, const std::string& agent) const;
  /// Esc closes the window when it is pressed twice: who presses it once may have meant a field or a menu.
  bool IsSecondEscape();

  Engine& engine_;
  PanelHost& host_;
  Workspace workspace_;
  PanelInput input_;
  PictureRect picture_;
  bool closes_help_ = false;
  std::chrono::steady_clock::time_point escaped_at_;
  std::optional<UiScript> script_;
  FrameMeter meter_;
};

}  // namespace soarbox::viewer
