// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_context.h"

#include <cassert>

namespace soarbox::script {

ScriptContext& ContextOf(lua_State* state) {
  ScriptContext* context = LuaMachine::Of(state).context();
  assert(context);
  return *context;
}

}  // namespace soarbox::script
