// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>

#include "diagnostics/result.h"

namespace soarbox::app {

/// Returns the file that loads all rules of a VisualSoar project; for other files, the file itself. Fails if the
/// project cannot be read or has no such file.
Result<std::filesystem::path> RulesOfProject(const std::filesystem::path& file);

}  // namespace soarbox::app
