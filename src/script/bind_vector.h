// SPDX-License-Identifier: BSD-2-Clause
#pragma once

struct lua_State;

namespace soarbox::script {

/// Fills the metatable on top of the stack with the operators of vectors (lua_api.md 2.2).
void InstallVectorMetamethods(lua_State* state);

}  // namespace soarbox::script
