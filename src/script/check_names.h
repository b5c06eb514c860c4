// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::script {

/// Names in a script that are nearly those of the API's functions (Agent.SetPositon) or of the functions that a sandbox
/// calls (Agent_Updat), with line and column, as warnings. Runs nothing.
std::vector<Diagnostic> CheckNames(std::string_view text, const std::string& file);

/// Of these, only the functions that a sandbox never calls, as a run reports them: the others are errors when they are
/// called.
std::vector<Diagnostic> CheckCallbackNames(std::string_view text, const std::string& file);

/// The text of a script with comments and texts blanked, so that places stay.
std::string BlankedCode(std::string_view text);

}  // namespace soarbox::script
