// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;

namespace soarbox::script {

/// Opens the harmless part of Lua's library `os`, by the clock of the simulation, so that runs repeat: clock, time,
/// date and difftime, where the first tick begins at midnight of 1 January 2000 (UTC); getenv, which knows no variable;
/// and exit, which ends all scripts of the world. Files and processes are left out.
void InstallOs(lua_State* state);

}  // namespace soarbox::script
