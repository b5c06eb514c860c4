// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soarbox::sim {

/// All names of keys that scripts can hear of (spec 4.1), sorted.
const std::vector<std::string>& KeyNames();
/// All names of buttons of the mouse, sorted.
const std::vector<std::string>& ButtonNames();

}  // namespace soarbox::sim
