// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace soarbox::cli {

inline constexpr std::string_view kSoarboxVersion = SOARBOX_VERSION;

}  // namespace soarbox::cli
