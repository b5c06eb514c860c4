// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "viewer/free_camera.h"
#include "viewer/input_event.h"
#include "viewer/picking.h"

struct SDL_Window;
union SDL_Event;

namespace soarbox::viewer {

/// Everything that the user did since the last frame, sorted by who cares.
struct FrameInput {
  std::vector<InputEvent> events;       ///< For the scripts.
  std::vector<ViewerCommand> commands;  ///< For the application.
  CameraInput camera;
  std::vector<ScreenPoint> clicks;  ///< Left clicks that were no drags.
  bool toggle_help = false, toggle_labels = false, toggle_follow = false;
  bool closed = false;                ///< The window was closed.
  int new_width = 0, new_height = 0;  ///< The window's new size; 0: unchanged.
};

/// Reads SDL's events and knows what is held down.
class InputReader {
 public:
  explicit InputReader(SDL_Window* window) : window_(window) {}
  FrameInput Read();

 private:
  void Handle(const SDL_Event& event, FrameInput& input);
  void HandleKey(int scancode, bool pressed, FrameInput& input);
  InputEvent MouseEvent(InputKind kind, int x, int y) const;

  SDL_Window* window_;
  bool looking_ = false;
  bool left_down_ = false;
  int left_x_ = 0, left_y_ = 0;
};

}  // namespace soarbox::viewer
