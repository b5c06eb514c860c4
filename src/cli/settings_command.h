// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "cli/command.h"

namespace soarbox::cli {

/// Executes `GROUP NAME [VALUE]`: shows or sets a setting ("NAME is VALUE"). A unique prefix of the name is sufficient.
/// `unknown` and `invalid` are the messages for an unknown name and an invalid value.
bool NamedSetting(CommandCall& call, std::string_view group, std::string_view unknown, std::string_view invalid);

}  // namespace soarbox::cli
