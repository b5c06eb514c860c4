// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "viewer/camera_rig.h"
#include "viewer/pad_reader.h"
#include "viewer/picking.h"
#include "viewer/viewer_command.h"
#include "viewer/window_input.h"

struct SDL_Window;
union SDL_Event;

namespace soarbox::viewer {

/// A left click on the scene, or the box of a left drag.
struct Picked {
  ScreenPoint from, to;  ///< Equal for a click; else two opposite corners.
  bool is_box = false;
  bool is_double = false;  ///< It is the second click of a double click.
  bool adds = false;       ///< Shift or Ctrl was held: add to the selection, or remove from it.
};

/// All user input since the last frame, by recipient.
struct FrameInput {
  std::vector<InputEvent> events;       ///< For the scripts.
  std::vector<ViewerCommand> commands;  ///< For the window and the application.
  CameraInput camera;
  std::vector<Picked> picked;
  std::optional<Picked> box;          ///< The box while the user draws it.
  std::optional<ScreenPoint> cursor;  ///< Over the scene; none over a panel, outside the window, or during a drag.
  bool closed = false;                ///< The window was closed.
  int new_width = 0, new_height = 0;  ///< The window's new size; 0: unchanged.
};

/// Decides which input the scene does not get.
struct InputClaims {
  /// Called with each event before the scene. If it returns true, neither the scene nor the scripts get the event. It
  /// may change the mouse position if the origin of the scene differs from the window's. May be empty.
  std::function<bool(SDL_Event&)> takes = {};
  bool mouse = false;   ///< The mouse is over a panel.
  bool keys = false;    ///< The user types into a panel: held keys do not move the camera.
  bool arrows = false;  ///< A list uses the arrow keys: they do not move the camera.
};

/// Reads SDL's events, including those of gamepads, and stores which keys and buttons are held down.
///
/// Left click selects, left drag selects a box, right drag looks around or circles, middle drag moves, the wheel zooms.
class InputReader {
 public:
  explicit InputReader(SDL_Window* window) : window_(window) {}
  FrameInput Read(const InputClaims& claims = {});

 private:
  void Handle(const SDL_Event& event, FrameInput& input);
  void HandleKey(int scancode, int modifiers, bool pressed, FrameInput& input);
  void HandleButton(const SDL_Event& event, FrameInput& input);
  void ReadHeldKeys(FrameInput& input, bool with_arrows) const;
  InputEvent MouseEvent(InputKind kind, int x, int y) const;

  SDL_Window* window_;
  PadReader pads_;
  bool looking_ = false, panning_ = false;
  bool left_down_ = false, is_box_ = false;
  ScreenPoint left_at_, cursor_;
  bool has_cursor_ = false;
};

}  // namespace soarbox::viewer
