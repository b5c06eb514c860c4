// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "script/lua_machine.h"

namespace soarbox::script {

/// Create one in each built-in function while it may call a script's function. Such nested calls use the process's own
/// stack, so their number is limited; one more raises a Lua error. Lua's errors run destructors.
class NestedCall {
 public:
  explicit NestedCall(lua_State* state);
  ~NestedCall() { --machine_.nested_calls_; }
  NestedCall(const NestedCall&) = delete;
  NestedCall& operator=(const NestedCall&) = delete;

 private:
  LuaMachine& machine_;
};

}  // namespace soarbox::script
