// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "diagnostics/diagnostic.h"

namespace soarbox::script {

/// What keeps a script from compiling, with its line; nothing if it compiles. Runs nothing.
std::optional<Diagnostic> CheckSyntax(std::string_view text, const std::string& file);

}  // namespace soarbox::script
