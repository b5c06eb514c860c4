// SPDX-License-Identifier: BSD-2-Clause
#include "script/button_callbacks.h"

#include <lua.hpp>

#include "script/lua_values.h"

namespace soarbox::script {

void ButtonCallbacks::Set(world::UiId panel, LuaMachine& machine, int function) {
  Remove(panel);
  callbacks_[panel] = {&machine, function};
}

void ButtonCallbacks::Remove(world::UiId panel) {
  const auto it = callbacks_.find(panel);
  if (it == callbacks_.end()) return;
  it->second.machine->Release(it->second.function);
  callbacks_.erase(it);
}

void ButtonCallbacks::RemoveGone(const world::Ui& panels) {
  std::erase_if(callbacks_, [&](const auto& each) {
    if (panels.Find(each.first)) return false;
    each.second.machine->Release(each.second.function);
    return true;
  });
}

void ButtonCallbacks::Press(world::UiId panel, const OnResult& on_result) {
  const auto it = callbacks_.find(panel);
  if (it == callbacks_.end()) return;
  const Callback callback = it->second;
  const auto error = callback.machine->CallKept(callback.function, [&](lua_State* state) {
    PushSandbox(state);
    PushHandle(state, {ValueKind::kUi, Number(panel)});
    return 2;
  });
  on_result(*callback.machine, error);
}

}  // namespace soarbox::script
