// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::sim {

/// All names of keys that scripts can receive (lua_api.md 4.1), sorted.
const std::vector<std::string>& KeyNames();
/// All names of buttons of the mouse, sorted.
const std::vector<std::string>& ButtonNames();
/// All names of buttons and axes of gamepads, sorted.
const std::vector<std::string>& PadNames();
/// Whether it is the name of a button of gamepads, and not of an axis.
bool IsPadButton(std::string_view name);

}  // namespace soarbox::sim
