// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "script/lua_machine.h"
#include "script/lua_values.h"

namespace soarbox::script {

/// A field of a custom event. It can be copied between machines.
using EventValue = std::variant<float, bool, std::string, world::Vec3, Handle>;

/// A custom event (lua_api.md 4.4): a type and its fields.
struct ScriptEvent {
  std::string type;
  std::map<std::string, EventValue> fields;
};

/// Approximate memory of an event in bytes.
std::size_t SizeOf(const ScriptEvent& event);

/// Copies the fields of the table at `index` that can be copied between machines: keys that are strings or numbers;
/// values that are numbers or numeric strings, booleans, strings, vectors, and handles of agents, objects and the
/// sandbox.
ScriptEvent CopyEvent(lua_State* state, std::string_view type, int index);
/// Pushes a new table with the fields of the event.
void PushEvent(lua_State* state, const ScriptEvent& event);

/// Events that wait for the next step, and their callbacks. Every callback receives every event.
class EventQueue {
 public:
  /// Called after a callback of a machine: its error, or null.
  using OnResult = std::function<void(LuaMachine&, const ScriptError*)>;

  void Add(ScriptEvent event);
  std::size_t waiting() const { return waiting_.size(); }
  /// Approximate memory of the waiting events in bytes.
  std::size_t waiting_bytes() const { return waiting_bytes_; }
  std::size_t callbacks() const { return callbacks_.size(); }

  /// Sets the callback of a target (agent, object or the sandbox): a function that `machine` keeps. Replaces the
  /// previous one.
  void SetCallback(Handle target, LuaMachine& machine, int function);
  /// Drops the callback of an agent or object that was removed.
  void RemoveTarget(std::uint32_t number);
  /// Drops all callbacks that this machine keeps. Call it before the machine is destroyed.
  void RemoveMachine(LuaMachine& machine);

  /// Calls every callback for every waiting event: events in the order of their sending, callbacks in ascending number
  /// of their target. Events that are added meanwhile wait for the next step. `may_run` excludes machines.
  void Deliver(const std::function<bool(const LuaMachine&)>& may_run, const OnResult& on_result);

 private:
  struct Callback {
    Handle target;
    LuaMachine* machine;
    int function;
  };
  std::vector<ScriptEvent> waiting_;
  std::size_t waiting_bytes_ = 0;
  std::map<std::uint32_t, Callback> callbacks_;
};

}  // namespace soarbox::script
