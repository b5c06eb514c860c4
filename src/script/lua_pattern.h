// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;

namespace soarbox::script {

/// Replaces string.find, match, gmatch and gsub in a machine by versions that charge their work to the script's budget.
/// So a pattern that takes forever is stopped like an endless loop. Call it inside a protected call.
void InstallPatterns(lua_State* state);

}  // namespace soarbox::script
