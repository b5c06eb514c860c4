// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

namespace soarbox::sim {

/// The value of world::Agent::kind() for a body that another simulation controls.
inline constexpr std::string_view kForeignKind = "foreign";

}  // namespace soarbox::sim
