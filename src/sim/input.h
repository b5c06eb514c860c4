// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "world/math.h"

namespace soarbox::sim {

/// A key went down or up. Names are the sandbox's: "f1_key", "space_key".
struct KeyInput {
  std::string key;
  bool pressed = false;
  friend bool operator==(const KeyInput&, const KeyInput&) = default;
};

/// A button of the mouse went down or up ("left_button") at this place, in pixels from the window's top left.
struct ButtonInput {
  std::string button;
  bool pressed = false;
  float x_px = 0, y_px = 0;
  friend bool operator==(const ButtonInput&, const ButtonInput&) = default;
};

/// The pointer moved to this place, by this much.
struct PointerInput {
  float x_px = 0, y_px = 0;
  float dx_px = 0, dy_px = 0;
  friend bool operator==(const PointerInput&, const PointerInput&) = default;
};

/// The wheel turned by this many notches, positive away from the user.
struct WheelInput {
  float notches = 0;
  float x_px = 0, y_px = 0;
  friend bool operator==(const WheelInput&, const WheelInput&) = default;
};

/// A button that a script has put on the screen was pressed: UI.SetButton gave it this name.
struct PanelInput {
  std::string button;
  friend bool operator==(const PanelInput&, const PanelInput&) = default;
};

/// Maximum number of gamepads.
inline constexpr int kMostPads = 8;

/// A button of a gamepad went down (1) or up (0), or an axis moved: sticks from -1 to 1, y downwards, triggers from 0
/// to 1. Names are those of input_names.h.
struct PadInput {
  int pad = 1;  ///< Which gamepad, from 1.
  std::string part;
  float value = 0;
  friend bool operator==(const PadInput&, const PadInput&) = default;
};

/// The window has this size.
struct ScreenInput {
  int width_px = 1, height_px = 1;
  friend bool operator==(const ScreenInput&, const ScreenInput&) = default;
};

/// The user's free look has moved the camera here; scripts ask for it.
struct CameraInput {
  world::Vec3 position;
  world::Quat orientation;
  friend bool operator==(const CameraInput&, const CameraInput&) = default;
};

/// A line of the Soar command language for an agent's mind: from a debugger, or an edit of its rules (`sp {...}`,
/// `excise`).
struct CommandInput {
  std::string agent;
  std::string line;
  friend bool operator==(const CommandInput&, const CommandInput&) = default;
};

/// Lua text that runs in the machine of an agent, or of the sandbox if `agent` is empty. Functions that it defines
/// replace those of the same name: this is how you edit a script while it runs.
struct ScriptInput {
  std::string agent;
  std::string text;
  friend bool operator==(const ScriptInput&, const ScriptInput&) = default;
};

/// The user orders an agent to do something. Scripts hear of it as a custom event of the type "Order" with the fields
/// `agent` (a handle) and `order` (the text).
struct OrderInput {
  std::string agent;
  std::string order;
  friend bool operator==(const OrderInput&, const OrderInput&) = default;
};

/// Where another simulation says that a body of its own is and how it moves. The body is made if it is not there yet,
/// and moves on from here until the next input comes.
struct ForeignBodyInput {
  std::string id;    ///< What its simulation calls it: "1:7:12".
  std::string name;  ///< Shown, and perceived.
  std::string team;
  std::string body;  ///< A kind of body.
  float health = 100;
  std::string stance = "standing";  ///< Or "crouching".
  world::Vec3 position;             ///< Of the feet, m.
  world::Vec3 velocity;             ///< m/s
  world::Vec3 acceleration;         ///< m/s2
  float heading_deg = 0;            ///< 0 along z, 90 along x.
  float turn_dps = 0;               ///< Degrees per second towards larger headings.
  friend bool operator==(const ForeignBodyInput&, const ForeignBodyInput&) = default;
};

/// Such a body has left.
struct ForeignGoneInput {
  std::string id;
  friend bool operator==(const ForeignGoneInput&, const ForeignGoneInput&) = default;
};

/// A shot of another simulation as it went. The agent that it hit loses that much health.
struct ForeignShotInput {
  std::string id;      ///< The shooter's.
  std::string target;  ///< Name of an agent of ours; empty: it hit none.
  float damage = 0;
  float radius_m = 0;  ///< It also takes health from those within this radius of where it ended, less with distance.
  world::Vec3 from, to;
  friend bool operator==(const ForeignShotInput&, const ForeignShotInput&) = default;
};

/// What a foreign body says to a team.
struct ForeignMessageInput {
  std::string id;
  std::string team;  ///< Empty: its own.
  std::string about;
  std::string text;  ///< Names and values, one after the other: "waypoint gate range 12".
  friend bool operator==(const ForeignMessageInput&, const ForeignMessageInput&) = default;
};

using InputValue = std::variant<KeyInput, ButtonInput, PointerInput, WheelInput, ScreenInput, CameraInput, CommandInput,
                                ScriptInput, OrderInput, ForeignBodyInput, ForeignGoneInput, ForeignShotInput,
                                ForeignMessageInput, PanelInput, PadInput>;

/// Something that reaches a simulation from outside, at the beginning of a tick. The first tick is 1.
struct Input {
  std::uint64_t tick = 0;
  InputValue value;
  /// Read from a recording: a stranger may have made it, so its commands write and start nothing.
  bool recorded = false;
  friend bool operator==(const Input&, const Input&) = default;
};

using InputList = std::vector<Input>;

}  // namespace soarbox::sim
