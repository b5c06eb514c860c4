// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::world {

/// Why a file from anywhere is no sound that windows and pages can play: "this is not a WAV file". Empty if it is one:
/// WAV with 8 or 16 bits, one or two channels, and 8,000 to 48,000 samples a second.
std::string WhyNoWav(std::string_view file);

}  // namespace soarbox::world
