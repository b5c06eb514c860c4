// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "script/callbacks.h"
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

/// Events that wait for the next step.
class EventQueue {
 public:
  void Add(ScriptEvent event);
  std::size_t waiting() const { return waiting_.size(); }
  /// Approximate memory of the waiting events in bytes.
  std::size_t waiting_bytes() const { return waiting_bytes_; }

  /// Calls every listener, which is an agent, an object or the sandbox, for every waiting event: events in the order of
  /// their sending, listeners in ascending number. Events that are added meanwhile wait for the next step.
  void Deliver(const Callbacks& listeners, const Callbacks::MayRun& may_run, const Callbacks::OnResult& on_result);

 private:
  std::vector<ScriptEvent> waiting_;
  std::size_t waiting_bytes_ = 0;
};

}  // namespace soarbox::script
