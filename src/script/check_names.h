// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::script {

// Checks of the names in a script, with line and column. They do not run the script.

/// Warns of names that are nearly those of API functions (Agent.SetPositon) or of functions that a sandbox calls
/// (Agent_Updat).
std::vector<Diagnostic> CheckNames(std::string_view text, const std::string& file);

/// Returns only the second kind: functions that a sandbox never calls. A run reports these; the others are errors when
/// they are called.
std::vector<Diagnostic> CheckCallbackNames(std::string_view text, const std::string& file);

using GlobalNames = std::set<std::string, std::less<>>;

/// Adds the global names that a script may set: functions that it defines, and all names that it assigns.
void AddGlobalsOf(std::string_view text, GlobalNames& names);

/// Returns the modules that a script loads by calling require with a literal, in their order.
std::vector<std::string> ModulesOf(std::string_view text);

/// Warns of calls of functions that nothing defines. `known` contains the globals of the other files that its machine
/// may run. A name that occurs in any other way than as a call is not reported: it may be an argument, a local
/// variable, or tested before it is called.
std::vector<Diagnostic> CheckCalls(std::string_view text, const std::string& file, const GlobalNames& known);

}  // namespace soarbox::script
