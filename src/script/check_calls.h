// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::script {

using GlobalNames = std::set<std::string, std::less<>>;

/// Names that a script may give a value to as globals: functions that it defines, and all that it assigns.
void AddGlobalsOf(std::string_view text, GlobalNames& names);

/// The modules that a script loads with require and a text between quotes, in their order.
std::vector<std::string> ModulesOf(std::string_view text);

/// Calls of functions that nothing defines, with line and column, as warnings. `known`: globals of the other files that
/// its machine may run. A name that occurs in any other way than as a call is not reported: it may be an argument, a
/// local, or tested before it is called. Runs nothing.
std::vector<Diagnostic> CheckCalls(std::string_view text, const std::string& file, const GlobalNames& known);

}  // namespace soarbox::script
