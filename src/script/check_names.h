// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::script {

/// Warns of names that are nearly those of API functions (Agent.SetPositon) or of functions that a sandbox calls
/// (Agent_Updat), with line and column. Does not run the script.
std::vector<Diagnostic> CheckNames(std::string_view text, const std::string& file);

/// Returns only the second kind: functions that a sandbox never calls. A run reports these; the others are errors when
/// they are called.
std::vector<Diagnostic> CheckCallbackNames(std::string_view text, const std::string& file);

/// Returns the script with comments and strings replaced by blanks, so that positions stay the same.
std::string BlankedCode(std::string_view text);

}  // namespace soarbox::script
