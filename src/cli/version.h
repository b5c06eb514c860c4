// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace soarbox::cli {

/// The release of Soar whose commands, texts and behaviour these are.
inline constexpr std::string_view kSoarVersion = "9.6.3";
inline constexpr std::string_view kSoarboxVersion = SOARBOX_VERSION;

}  // namespace soarbox::cli
