// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>

#include "script/lua_machine.h"
#include "world/entity_ids.h"
#include "world/ui.h"

namespace soarbox::script {

/// Functions that the sandbox script registered for its buttons (UI.SetButton). Scripts of agents have no table UI.
class ButtonCallbacks {
 public:
  /// Called after a callback has run in this machine, with its error if it failed.
  using OnResult = std::function<void(LuaMachine&, const std::optional<ScriptError>&)>;

  /// Sets the callback of a panel: a function that `machine` keeps. Replaces the previous one.
  void Set(world::UiId panel, LuaMachine& machine, int function);
  void Remove(world::UiId panel);
  /// Removes the callbacks of panels that no longer exist.
  void RemoveGone(const world::Ui& panels);
  std::size_t size() const { return callbacks_.size(); }

  /// Calls callback(sandbox, panel). Does nothing if the panel has no callback.
  void Press(world::UiId panel, const OnResult& on_result);

 private:
  struct Callback {
    LuaMachine* machine;
    int function;
  };
  std::map<world::UiId, Callback> callbacks_;
};

}  // namespace soarbox::script
