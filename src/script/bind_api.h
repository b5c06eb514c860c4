// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;

namespace soarbox::script {

/// The machine that the API is for: only the sandbox's own has the table UI.
enum class ApiSide { kSandbox, kAgent };

/// Registers the tables of the sandbox's API (api_table.h) and the metatables. Call it inside a protected call, in a
/// machine with a context.
void BindApi(lua_State* state, ApiSide side);

}  // namespace soarbox::script
