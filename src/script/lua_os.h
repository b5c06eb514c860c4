// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;

namespace soarbox::script {

/// Opens the harmless part of Lua's library `os` with the simulation's clock, so that runs are repeatable. clock, time,
/// date and difftime: the first tick is midnight of 1 January 2000 (UTC). getenv finds no variable. exit ends all
/// scripts of the world. Files and processes are left out.
void InstallOs(lua_State* state);

}  // namespace soarbox::script
