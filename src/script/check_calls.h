// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::script {

using GlobalNames = std::set<std::string, std::less<>>;

/// Adds the global names that a script may set: functions that it defines, and all names that it assigns.
void AddGlobalsOf(std::string_view text, GlobalNames& names);

/// Returns the modules that a script loads by calling require with a literal, in their order.
std::vector<std::string> ModulesOf(std::string_view text);

/// Warns of calls of functions that nothing defines, with line and column. `known` contains the globals of the other
/// files that its machine may run. A name that occurs in any other way than as a call is not reported: it may be an
/// argument, a local variable, or tested before it is called. Does not run the script.
std::vector<Diagnostic> CheckCalls(std::string_view text, const std::string& file, const GlobalNames& known);

}  // namespace soarbox::script
