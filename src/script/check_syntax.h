// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "diagnostics/diagnostic.h"

namespace soarbox::script {

/// Returns the compile error of a script with its line; nothing if it compiles. Does not run the script.
std::optional<Diagnostic> CheckSyntax(std::string_view text, const std::string& file);

}  // namespace soarbox::script
