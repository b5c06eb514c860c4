// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;

namespace soarbox::script {

/// Guards functions of the standard library that call functions of scripts (table.sort, coroutine.resume,
/// coroutine.wrap: NestedCall). Charges functions that do much work in one instruction (sorting, shifting, repeating,
/// joining).
void InstallGuards(lua_State* state);

}  // namespace soarbox::script
