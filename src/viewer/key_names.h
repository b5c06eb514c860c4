// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::viewer {

/// Returns the sandbox's name of a key ("f1_key", "numpad_3_key") for its SDL scan code, or "unknown_key". Names follow
/// the position of a key on a US keyboard, like those of the sandbox.
std::string KeyName(int sdl_scancode);

/// Returns the sandbox's name of a mouse button for SDL's number, from 1.
std::string MouseButtonName(int sdl_button);

}  // namespace soarbox::viewer
