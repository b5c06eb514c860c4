// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "script/lua_machine.h"
#include "script/lua_values.h"

namespace soarbox::script {

/// Functions that scripts registered for things of the world. The machines of these scripts keep them.
class Callbacks {
 public:
  using MayRun = std::function<bool(const LuaMachine&)>;
  /// Called after a function has run in this machine, with its error if it failed.
  using OnResult = std::function<void(LuaMachine&, const std::optional<ScriptError>&)>;

  /// Adds the function at `index` of the running call.
  void Add(Handle thing, lua_State* state, int index);
  /// The same, in place of the thing's other functions.
  void Set(Handle thing, lua_State* state, int index);
  void Remove(std::uint32_t number);
  /// Drops the functions of the things for which `is_gone` returns true.
  template <class IsGone>
  void RemoveIf(const IsGone& is_gone) {
    for (auto it = callbacks_.begin(); it != callbacks_.end();) {
      const std::uint32_t number = it->first;
      ++it;
      if (is_gone(number)) Remove(number);
    }
  }
  /// Drops all functions that this machine keeps. Call it before the machine is destroyed.
  void RemoveMachine(const LuaMachine& machine);
  std::size_t size() const { return size_; }

  /// Pushes the arguments of a function and returns their number. The first two are the sandbox and the thing.
  using Push = std::function<int(lua_State*, Handle thing)>;
  /// Calls the functions of a thing in the order in which they were added. Functions that are added meanwhile wait for
  /// the next call.
  void Call(std::uint32_t number, const MayRun& may_run, const OnResult& on_result, const Push& push) const;
  /// The same for all things by ascending number.
  void CallAll(const MayRun& may_run, const OnResult& on_result, const Push& push) const;

 private:
  struct Callback {
    Handle thing;
    LuaMachine* machine;
    int function;
  };
  std::map<std::uint32_t, std::vector<Callback>> callbacks_;
  std::size_t size_ = 0;
};

}  // namespace soarbox::script
