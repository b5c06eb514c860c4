// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/input_reader.h"

#include <SDL.h>

#include <cstdlib>

#include "viewer/key_names.h"

namespace soarbox::viewer {

InputEvent InputReader::MouseEvent(InputKind kind, int x, int y) const {
  InputEvent event;
  event.kind = kind;
  event.x = x;
  event.y = y;
  SDL_GetWindowSize(window_, &event.width, &event.height);
  return event;
}

void InputReader::HandleKey(int scancode, bool pressed, FrameInput& input) {
  InputEvent event;
  event.pressed = pressed;
  event.name = KeyName(scancode);
  input.events.push_back(event);
  if (!pressed) return;
  switch (scancode) {
    case SDL_SCANCODE_P:
    case SDL_SCANCODE_PAUSE:
      input.commands.push_back(ViewerCommand::kTogglePause);
      break;
    case SDL_SCANCODE_N:
    case SDL_SCANCODE_PERIOD:
      input.commands.push_back(ViewerCommand::kSingleStep);
      break;
    case SDL_SCANCODE_EQUALS:
    case SDL_SCANCODE_KP_PLUS:
      input.commands.push_back(ViewerCommand::kFaster);
      break;
    case SDL_SCANCODE_MINUS:
    case SDL_SCANCODE_KP_MINUS:
      input.commands.push_back(ViewerCommand::kSlower);
      break;
    case SDL_SCANCODE_ESCAPE:
      input.commands.push_back(ViewerCommand::kQuit);
      break;
    case SDL_SCANCODE_H:
      input.toggle_help = !input.toggle_help;
      break;
    case SDL_SCANCODE_L:
      input.toggle_labels = !input.toggle_labels;
      break;
    case SDL_SCANCODE_C:
      input.toggle_follow = !input.toggle_follow;
      break;
    default:
      break;
  }
}

void InputReader::Handle(const SDL_Event& event, FrameInput& input) {
  constexpr int kDrag_px = 5;
  switch (event.type) {
    case SDL_QUIT:
      input.closed = true;
      break;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED) {
        input.new_width = event.window.data1;
        input.new_height = event.window.data2;
      } else if (event.window.event == SDL_WINDOWEVENT_CLOSE) {
        input.closed = true;
      } else if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST && looking_) {
        looking_ = false;
        SDL_SetRelativeMouseMode(SDL_FALSE);
      }
      break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      if (event.key.repeat == 0) HandleKey(event.key.keysym.scancode, event.type == SDL_KEYDOWN, input);
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP: {
      const bool pressed = event.type == SDL_MOUSEBUTTONDOWN;
      InputEvent out = MouseEvent(InputKind::kMouseButton, event.button.x, event.button.y);
      out.pressed = pressed;
      out.name = MouseButtonName(event.button.button);
      input.events.push_back(out);
      if (event.button.button == SDL_BUTTON_RIGHT) {
        looking_ = pressed;
        SDL_SetRelativeMouseMode(pressed ? SDL_TRUE : SDL_FALSE);
      } else if (event.button.button == SDL_BUTTON_LEFT) {
        if (left_down_ && !pressed && std::abs(out.x - left_x_) <= kDrag_px && std::abs(out.y - left_y_) <= kDrag_px) {
          input.clicks.push_back({static_cast<float>(out.x), static_cast<float>(out.y)});
        }
        left_down_ = pressed;
        left_x_ = out.x;
        left_y_ = out.y;
      }
      break;
    }
    case SDL_MOUSEMOTION: {
      InputEvent out = MouseEvent(InputKind::kMouseMove, event.motion.x, event.motion.y);
      out.dx = event.motion.xrel;
      out.dy = event.motion.yrel;
      input.events.push_back(out);
      if (looking_) {
        input.camera.mouse_dx += static_cast<float>(event.motion.xrel);
        input.camera.mouse_dy += static_cast<float>(event.motion.yrel);
      }
      break;
    }
    case SDL_MOUSEWHEEL: {
      int x = 0, y = 0;
      SDL_GetMouseState(&x, &y);
      InputEvent out = MouseEvent(InputKind::kMouseMove, x, y);
      out.wheel = event.wheel.y;
      input.events.push_back(out);
      input.camera.wheel += static_cast<float>(event.wheel.y);
      break;
    }
    default:
      break;
  }
}

FrameInput InputReader::Read() {
  FrameInput input;
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) Handle(event, input);

  const Uint8* keys = SDL_GetKeyboardState(nullptr);
  const auto axis = [keys](std::initializer_list<int> plus, std::initializer_list<int> minus) {
    float value = 0;
    for (const int key : plus) {
      if (keys[key] != 0) value = 1;
    }
    for (const int key : minus) {
      if (keys[key] != 0) value -= 1;
    }
    return value;
  };
  input.camera.forward = axis({SDL_SCANCODE_W, SDL_SCANCODE_UP}, {SDL_SCANCODE_S});
  input.camera.forward += axis({}, {SDL_SCANCODE_DOWN});
  input.camera.left = axis({SDL_SCANCODE_A, SDL_SCANCODE_LEFT}, {SDL_SCANCODE_D});
  input.camera.left += axis({}, {SDL_SCANCODE_RIGHT});
  input.camera.up = axis({SDL_SCANCODE_E, SDL_SCANCODE_PAGEUP}, {SDL_SCANCODE_Q});
  input.camera.up += axis({}, {SDL_SCANCODE_PAGEDOWN});
  input.camera.fast = keys[SDL_SCANCODE_LSHIFT] != 0 || keys[SDL_SCANCODE_RSHIFT] != 0;
  input.camera.looking = looking_;
  return input;
}

}  // namespace soarbox::viewer
