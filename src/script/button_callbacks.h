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
  /// What came of the call in that machine: its error, or nothing.
  using OnResult = std::function<void(LuaMachine&, const std::optional<ScriptError>&)>;

  /// A function that `machine` keeps; it replaces an earlier one of the panel.
  void Set(world::UiId panel, LuaMachine& machine, int function);
  void Remove(world::UiId panel);
  /// Removes those of panels that no longer exist.
  void RemoveGone(const world::Ui& panels);
  std::size_t size() const { return callbacks_.size(); }

  /// Calls callback(sandbox, panel). Nothing happens if the panel has none.
  void Press(world::UiId panel, const OnResult& on_result);

 private:
  struct Callback {
    LuaMachine* machine;
    int function;
  };
  std::map<world::UiId, Callback> callbacks_;
};

}  // namespace soarbox::script
