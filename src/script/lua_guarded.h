// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;

namespace soarbox::script {

/// Puts guards around functions of the standard library that call back into scripts (table.sort, coroutine.resume,
/// coroutine.wrap: NestedCall), and a price on those that do much work in one instruction (sorting, shifting,
/// repeating, joining).
void InstallGuards(lua_State* state);

}  // namespace soarbox::script
