// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "cli/command.h"

namespace soarbox::cli {

/// Carries out `GROUP NAME [VALUE]`: shows or sets a setting of the store ("NAME is VALUE"). The name may be any unique
/// beginning. The messages answer an unknown name and a value that does not fit.
bool NamedSetting(CommandCall& call, std::string_view group, std::string_view unknown, std::string_view invalid);

}  // namespace soarbox::cli
