// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::viewer {

/// The sandbox's name of a key ("f1_key", "numpad_3_key") by its SDL scan code; "unknown_key" for all others.
/// Names follow the place of a key on a US keyboard, as the sandbox's do.
std::string KeyName(int sdl_scancode);

/// The sandbox's name of a mouse button by SDL's number, from 1.
std::string MouseButtonName(int sdl_button);

}  // namespace soarbox::viewer
