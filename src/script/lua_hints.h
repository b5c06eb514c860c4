// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::script {

/// What to do about an error of Lua: `message` without its place, `line` the text of the line that it is about. Knows
/// forms of other languages, names without a value, and functions that the sandbox does not have. Empty if it knows
/// nothing.
std::string HintForLua(std::string_view message, std::string_view line);

}  // namespace soarbox::script
