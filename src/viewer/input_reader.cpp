// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/input_reader.h"

#include <SDL.h>

#include <cmath>

#include "viewer/key_names.h"

namespace soarbox::viewer {
namespace {

constexpr float kDrag_px = 5;

bool IsHeld(int modifiers, int which) {
  return (modifiers & which) != 0;
}

}  // namespace

InputEvent InputReader::MouseEvent(InputKind kind, int x, int y) const {
  InputEvent event;
  event.kind = kind;
  event.x = x;
  event.y = y;
  SDL_GetWindowSize(window_, &event.width, &event.height);
  return event;
}

void InputReader::HandleKey(int scancode, int modifiers, bool pressed, FrameInput& input) {
  InputEvent event;
  event.pressed = pressed;
  event.name = KeyName(scancode);
  input.events.push_back(event);
  if (!pressed || IsHeld(modifiers, KMOD_ALT)) return;
  if (const auto command = CommandOfKey(scancode, IsHeld(modifiers, KMOD_SHIFT), IsHeld(modifiers, KMOD_CTRL)))
    input.commands.push_back(*command);
}

void InputReader::HandleButton(const SDL_Event& event, FrameInput& input) {
  const bool pressed = event.type == SDL_MOUSEBUTTONDOWN;
  InputEvent out = MouseEvent(InputKind::kMouseButton, event.button.x, event.button.y);
  out.pressed = pressed;
  out.name = MouseButtonName(event.button.button);
  input.events.push_back(out);
  const ScreenPoint at{static_cast<float>(out.x), static_cast<float>(out.y)};
  switch (event.button.button) {
    case SDL_BUTTON_RIGHT:
      looking_ = pressed;
      SDL_SetRelativeMouseMode(pressed ? SDL_TRUE : SDL_FALSE);
      break;
    case SDL_BUTTON_MIDDLE:
      panning_ = pressed;
      break;
    case SDL_BUTTON_LEFT:
      if (left_down_ && !pressed) {
        const bool far = std::abs(at.x - left_at_.x) > kDrag_px || std::abs(at.y - left_at_.y) > kDrag_px;
        const bool adds = IsHeld(SDL_GetModState(), KMOD_SHIFT | KMOD_CTRL);
        const bool is_box = far || is_box_;
        input.picked.push_back({left_at_, is_box ? at : left_at_, is_box, !is_box && event.button.clicks == 2, adds});
      }
      left_down_ = pressed;
      is_box_ = false;
      left_at_ = at;
      break;
    default:
      break;
  }
}

void InputReader::Handle(const SDL_Event& event, FrameInput& input) {
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
      } else if (event.window.event == SDL_WINDOWEVENT_LEAVE) {
        has_cursor_ = false;
      } else if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
        if (looking_) SDL_SetRelativeMouseMode(SDL_FALSE);
        looking_ = panning_ = left_down_ = is_box_ = false;
      }
      break;
    case SDL_KEYDOWN:
    case SDL_KEYUP:
      if (event.key.repeat == 0)
        HandleKey(event.key.keysym.scancode, event.key.keysym.mod, event.type == SDL_KEYDOWN, input);
      break;
    case SDL_MOUSEBUTTONDOWN:
    case SDL_MOUSEBUTTONUP:
      HandleButton(event, input);
      break;
    case SDL_MOUSEMOTION: {
      InputEvent out = MouseEvent(InputKind::kMouseMove, event.motion.x, event.motion.y);
      out.dx = event.motion.xrel;
      out.dy = event.motion.yrel;
      input.events.push_back(out);
      if (!looking_) {
        cursor_ = {static_cast<float>(out.x), static_cast<float>(out.y)};
        has_cursor_ = true;
      }
      if (left_down_ && (std::abs(cursor_.x - left_at_.x) > kDrag_px || std::abs(cursor_.y - left_at_.y) > kDrag_px))
        is_box_ = true;
      if (looking_ || panning_) {
        input.camera.mouse_dx += static_cast<float>(event.motion.xrel);
        input.camera.mouse_dy += static_cast<float>(event.motion.yrel);
      }
      break;
    }
    case SDL_MOUSEWHEEL: {
      InputEvent out = MouseEvent(InputKind::kMouseMove, static_cast<int>(cursor_.x), static_cast<int>(cursor_.y));
      out.wheel = event.wheel.y;
      input.events.push_back(out);
      input.camera.wheel += static_cast<float>(event.wheel.y);
      break;
    }
    default:
      pads_.Handle(event, input.events);
      break;
  }
}

void InputReader::ReadHeldKeys(FrameInput& input, bool with_arrows) const {
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
  // With Ctrl, these keys are commands.
  if (keys[SDL_SCANCODE_LCTRL] != 0 || keys[SDL_SCANCODE_RCTRL] != 0) return;
  input.camera.forward = axis({SDL_SCANCODE_W}, {SDL_SCANCODE_S});
  input.camera.left = axis({SDL_SCANCODE_A}, {SDL_SCANCODE_D});
  if (with_arrows) {
    input.camera.forward += axis({SDL_SCANCODE_UP}, {SDL_SCANCODE_DOWN});
    input.camera.left += axis({SDL_SCANCODE_LEFT}, {SDL_SCANCODE_RIGHT});
  }
  input.camera.up = axis({SDL_SCANCODE_E, SDL_SCANCODE_PAGEUP}, {SDL_SCANCODE_Q});
  input.camera.up += axis({}, {SDL_SCANCODE_PAGEDOWN});
  input.camera.fast = keys[SDL_SCANCODE_LSHIFT] != 0 || keys[SDL_SCANCODE_RSHIFT] != 0;
}

FrameInput InputReader::Read(const InputClaims& claims) {
  FrameInput input;
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) {
    if (claims.takes && claims.takes(event)) continue;
    Handle(event, input);
  }
  pads_.ReportAxes(input.events);
  if (!claims.keys) ReadHeldKeys(input, !claims.arrows);
  input.camera.looking = looking_;
  input.camera.panning = panning_;
  if (left_down_ && is_box_) input.box = Picked{left_at_, cursor_, true, false, false};
  if (has_cursor_ && !claims.mouse && !looking_ && !panning_ && !is_box_) input.cursor = cursor_;
  return input;
}

}  // namespace soarbox::viewer
