// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::script {

/// Returns advice about a Lua error: `message` without its place, `line` is the text of the line of the error.
/// Recognises syntax of other languages, names without a value, and functions that the sandbox does not have. Empty if
/// there is no advice.
std::string HintForLua(std::string_view message, std::string_view line);

}  // namespace soarbox::script
