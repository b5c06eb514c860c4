// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "world/math.h"

namespace soarbox::sim {

/// A key was pressed or released. Key names are those of the sandbox: "f1_key", "space_key".
struct KeyInput {
  std::string key;
  bool pressed = false;
  friend bool operator==(const KeyInput&, const KeyInput&) = default;
};

/// A mouse button ("left_button") was pressed or released at this position, in pixels from the top left of the window.
struct ButtonInput {
  std::string button;
  bool pressed = false;
  float x_px = 0, y_px = 0;
  friend bool operator==(const ButtonInput&, const ButtonInput&) = default;
};

/// The pointer moved to this position, by this difference.
struct PointerInput {
  float x_px = 0, y_px = 0;
  float dx_px = 0, dy_px = 0;
  friend bool operator==(const PointerInput&, const PointerInput&) = default;
};

/// The wheel was turned; positive values are away from the user.
struct WheelInput {
  float notches = 0;
  float x_px = 0, y_px = 0;
  friend bool operator==(const WheelInput&, const WheelInput&) = default;
};

/// A button of a script's panel was pressed. `name` is the name that UI.SetButton gave it.
struct PanelInput {
  std::string button;
  friend bool operator==(const PanelInput&, const PanelInput&) = default;
};

/// Maximum number of gamepads.
inline constexpr int kMostPads = 8;

/// A button of a gamepad went down (1) or up (0), or an axis moved: sticks from -1 to 1, y downwards, triggers from 0
/// to 1. Names are those of input_names.h.
struct PadInput {
  int pad = 1;  ///< Number of the gamepad, from 1.
  std::string part;
  float value = 0;
  friend bool operator==(const PadInput&, const PadInput&) = default;
};

/// The window has this size.
struct ScreenInput {
  int width_px = 1, height_px = 1;
  friend bool operator==(const ScreenInput&, const ScreenInput&) = default;
};

/// The user moved the camera to this pose. Scripts can read it.
struct CameraInput {
  world::Vec3 position;
  world::Quat orientation;
  friend bool operator==(const CameraInput&, const CameraInput&) = default;
};

/// A line of the Soar command language for an agent's mind. Debuggers send such lines, and so do edits of its rules
/// (`sp {...}`, `excise`).
struct CommandInput {
  std::string agent;
  std::string line;
  friend bool operator==(const CommandInput&, const CommandInput&) = default;
};

/// Lua code that is executed in the machine of an agent, or of the sandbox if `agent` is empty. Functions in it replace
/// those of the same name: this is how scripts are edited while they run.
struct ScriptInput {
  std::string agent;
  std::string text;
  friend bool operator==(const ScriptInput&, const ScriptInput&) = default;
};

/// An order of the user to an agent. Scripts receive it as a custom event of the type "Order" with the fields `agent`
/// (a handle) and `order` (the text).
struct OrderInput {
  std::string agent;
  std::string order;
  friend bool operator==(const OrderInput&, const OrderInput&) = default;
};

/// Position and motion of a body of another simulation. The body is created if it does not exist, and moves on from
/// here until the next input.
struct ForeignBodyInput {
  std::string id;    ///< Its id in its simulation: "1:7:12".
  std::string name;  ///< The name that is shown and perceived.
  std::string team;
  std::string body;  ///< Name of a kind of body.
  float health = 100;
  std::string stance = "standing";  ///< Or "crouching".
  world::Vec3 position;             ///< Position of the feet, m.
  world::Vec3 velocity;             ///< m/s
  world::Vec3 acceleration;         ///< m/s2
  float heading_deg = 0;            ///< 0 along z, 90 along x.
  float turn_dps = 0;               ///< Turn rate in degrees per second, positive towards larger headings.
  friend bool operator==(const ForeignBodyInput&, const ForeignBodyInput&) = default;
};

/// A body of another simulation has left.
struct ForeignGoneInput {
  std::string id;
  friend bool operator==(const ForeignGoneInput&, const ForeignGoneInput&) = default;
};

/// A shot in another simulation. The target loses `damage` health.
struct ForeignShotInput {
  std::string id;      ///< Id of the shooter.
  std::string target;  ///< Name of one of our agents; empty: none was hit.
  float damage = 0;
  float radius_m = 0;  ///< Agents within this radius of `to` also lose health, less with distance.
  world::Vec3 from, to;
  friend bool operator==(const ForeignShotInput&, const ForeignShotInput&) = default;
};

/// A message of a foreign body to a team.
struct ForeignMessageInput {
  std::string id;
  std::string team;  ///< Empty: the team of the body.
  std::string about;
  std::string text;  ///< Alternating names and values: "waypoint gate range 12".
  friend bool operator==(const ForeignMessageInput&, const ForeignMessageInput&) = default;
};

using InputValue = std::variant<KeyInput, ButtonInput, PointerInput, WheelInput, ScreenInput, CameraInput, CommandInput,
                                ScriptInput, OrderInput, ForeignBodyInput, ForeignGoneInput, ForeignShotInput,
                                ForeignMessageInput, PanelInput, PadInput>;

/// An input from outside that takes effect at the beginning of a tick. The first tick is 1.
struct Input {
  std::uint64_t tick = 0;
  InputValue value;
  /// It comes from a recording, possibly by an untrusted author. Its commands may not write files or start programs.
  bool recorded = false;
  friend bool operator==(const Input&, const Input&) = default;
};

using InputList = std::vector<Input>;

}  // namespace soarbox::sim
