// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

namespace soarbox::viewer {

enum class InputKind : std::uint8_t { kKey, kMouseButton, kMouseMove, kPanel, kPad };

/// A user action, in the terms of the sandbox's scripts (the tables that Sandbox_HandleEvent receives).
struct InputEvent {
  InputKind kind = InputKind::kKey;
  bool pressed = false;       ///< Keys and buttons: down or up. Keys that repeat come only once.
  std::string name;           ///< "f1_key", "space_key"; "left_button"; empty for moves. kPanel: the button's own.
  int width = 0, height = 0;  ///< Mouse events: the window's size, as the sandbox has it.
  int x = 0, y = 0;           ///< Mouse events: the cursor, from the top left.
  int dx = 0, dy = 0;         ///< Moves: since the last one.
  int wheel = 0;              ///< Moves: notches, positive away from the user.
  int pad = 0;                ///< Gamepads: its number, from 1.
  float value = 0;            ///< Gamepads: 1 or 0 for buttons, -1 to 1 for axes.
};

}  // namespace soarbox::viewer
