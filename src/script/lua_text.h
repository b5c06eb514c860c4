// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

struct lua_State;

namespace soarbox::script {

/// Replaces tostring, string.format and print's formatting in a machine. Tables, functions and the like print as
/// "table: 0x00000003": a number that counts them in the order in which they were first printed, not their address,
/// so that output is the same in every run. Call inside a protected call.
void InstallText(lua_State* state);

/// Pushes what tostring gives for the value at `index`. May raise, as a __tostring can.
void PushText(lua_State* state, int index);

/// The value at `index` for a message: strings and numbers as they are, others by their kind. Never raises.
std::string DisplayText(lua_State* state, int index);

}  // namespace soarbox::script
