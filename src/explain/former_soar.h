// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::explain {

/// Returns what to write in Soar 9.6 instead of a command that Soar removed between versions 6 and 9.3. Returns an
/// empty string for any other word.
std::string FormerCommandHint(std::string_view command);
/// The same for a function that actions of rules could call.
std::string FormerFunctionHint(std::string_view function);
/// The same for syntax that the reader of rules no longer accepts: "&" and "@" of preferences, "goal".
std::string FormerSyntaxHint(std::string_view found);
/// The same for a command line that is refused because of an option: "learn -off".
std::string FormerOptionHint(std::string_view line);

}  // namespace soarbox::explain
