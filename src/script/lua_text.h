// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

struct lua_State;

namespace soarbox::script {

/// Replaces tostring, string.format and the formatting of print in a machine. Tables, functions and similar values
/// print as "table: 0x00000003". The number counts them in the order in which they were first printed, so that output
/// is the same in every run. Call it inside a protected call.
void InstallText(lua_State* state);

/// Pushes the result of tostring for the value at `index`. May raise, as __tostring can.
void PushText(lua_State* state, int index);

/// Formats the value at `index` for a message: strings and numbers themselves, others by their kind. Never raises.
std::string DisplayText(lua_State* state, int index);

}  // namespace soarbox::script
