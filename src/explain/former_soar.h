// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::explain {

/// What to write today instead of a command of Soar 6 to 9.3 that Soar 9.6 no longer knows. Empty for other words.
std::string FormerCommandHint(std::string_view command);
/// Likewise for a function that actions of rules could call.
std::string FormerFunctionHint(std::string_view function);
/// Likewise for syntax that the reader of rules no longer knows: "&" and "@" of preferences, "goal".
std::string FormerSyntaxHint(std::string_view found);
/// Likewise for the options of a command, where its line is refused: "learn -off".
std::string FormerOptionHint(std::string_view line);

}  // namespace soarbox::explain
