// SPDX-License-Identifier: BSD-2-Clause
#include "script/callbacks.h"

#include <lua.hpp>

namespace soarbox::script {

void Callbacks::Add(Handle thing, lua_State* state, int index) {
  lua_pushvalue(state, index);
  callbacks_[thing.number].push_back({thing, &LuaMachine::Of(state), luaL_ref(state, LUA_REGISTRYINDEX)});
  ++size_;
}

void Callbacks::Set(Handle thing, lua_State* state, int index) {
  Remove(thing.number);
  Add(thing, state, index);
}

void Callbacks::Remove(std::uint32_t number) {
  const auto found = callbacks_.find(number);
  if (found == callbacks_.end()) return;
  for (const Callback& callback : found->second) callback.machine->Release(callback.function);
  size_ -= found->second.size();
  callbacks_.erase(found);
}

void Callbacks::RemoveMachine(const LuaMachine& machine) {
  for (auto& [number, callbacks] : callbacks_) {
    size_ -= std::erase_if(callbacks, [&](const Callback& callback) {
      if (callback.machine != &machine) return false;
      callback.machine->Release(callback.function);
      return true;
    });
  }
  std::erase_if(callbacks_, [](const auto& entry) { return entry.second.empty(); });
}

void Callbacks::Call(std::uint32_t number, const MayRun& may_run, const OnResult& on_result, const Push& push) const {
  const auto found = callbacks_.find(number);
  if (found == callbacks_.end()) return;
  const std::vector<Callback> callbacks = found->second;
  for (const Callback& callback : callbacks) {
    if (!may_run(*callback.machine)) continue;
    const auto error =
        callback.machine->CallKept(callback.function, [&](lua_State* state) { return push(state, callback.thing); });
    on_result(*callback.machine, error);
  }
}

void Callbacks::CallAll(const MayRun& may_run, const OnResult& on_result, const Push& push) const {
  // A function may add and remove others.
  for (auto it = callbacks_.begin(); it != callbacks_.end();) {
    const std::uint32_t number = it->first;
    Call(number, may_run, on_result, push);
    it = callbacks_.upper_bound(number);
  }
}

}  // namespace soarbox::script
