// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "cli/command.h"

namespace soarbox::cli {

/// Carries out `GROUP NAME [VALUE]`: shows or sets a setting of the store ("NAME is VALUE"). A unique beginning of the
/// name suffices. The messages are for an unknown name and for an invalid value.
bool NamedSetting(CommandCall& call, std::string_view group, std::string_view unknown, std::string_view invalid);

}  // namespace soarbox::cli
