// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::script {

/// A key, mouse or gamepad event as scripts see it (lua_api.md 4.1, 4.2). Names are the sandbox's: "space_key",
/// "left_button".
struct InputEvent {
  enum class Source { kKeyboard, kMouse, kGamepad };
  Source source = Source::kKeyboard;
  bool pressed = false;  ///< Keys and buttons; not for mouse motion.
  std::string key;       ///< Keyboard only.
  std::string button;    ///< Of mouse or gamepad; empty: the mouse or an axis moved.
  float x = 0, y = 0;    ///< Mouse: pixels from the window's top left.
  float dx = 0, dy = 0;  ///< Mouse motion.
  float wheel = 0;       ///< Mouse wheel steps.
  int pad = 0;           ///< Number of the gamepad, from 1.
  std::string axis;      ///< Gamepad: name of the axis that moved.
  float value = 0;       ///< Gamepad: value of that axis, -1 to 1.
};

inline InputEvent KeyEvent(std::string key, bool pressed) {
  InputEvent event;
  event.pressed = pressed;
  event.key = std::move(key);
  return event;
}

}  // namespace soarbox::script
