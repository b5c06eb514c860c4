// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::world {

/// Checks whether a file is a WAV file that windows and pages can play: 8 or 16 bits, one or two channels, 8,000 to
/// 48,000 samples per second. Returns the reason if it is not, such as "this is not a WAV file"; else an empty text.
/// Accepts any content.
std::string WhyNoWav(std::string_view file);

}  // namespace soarbox::world
