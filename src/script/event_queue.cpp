// SPDX-License-Identifier: BSD-2-Clause
#include "script/event_queue.h"

#include <lua.hpp>
#include <utility>

#include "script/binding.h"

namespace soarbox::script {
namespace {

void WarnOfField(lua_State* state, const std::string& key, const char* what) {
  WarnAtCallerOnce(state,
                   "the event's field '" + key.substr(0, 40) + "' is " + what + ", which an event cannot contain", key);
}

/// Copies the value on top of the stack into the event if it can be copied between machines.
void CopyField(lua_State* state, std::string key, ScriptEvent& event) {
  if (lua_isnumber(state, -1)) {
    event.fields[std::move(key)] = static_cast<float>(lua_tonumber(state, -1));
  } else if (lua_isboolean(state, -1)) {
    event.fields[std::move(key)] = lua_toboolean(state, -1) != 0;
  } else if (lua_isstring(state, -1)) {
    std::size_t length = 0;
    const char* text = lua_tolstring(state, -1, &length);
    event.fields[std::move(key)] = std::string(text, length);
  } else if (const world::Vec3* vector = ToVector(state, -1)) {
    event.fields[std::move(key)] = *vector;
  } else if (const Handle* handle = ToHandle(state, -1)) {
    if (handle->kind == ValueKind::kAgent || handle->kind == ValueKind::kObject || handle->kind == ValueKind::kSandbox)
      event.fields[std::move(key)] = *handle;
    else
      WarnOfField(state, key, NameOf(handle->kind));
  } else {
    WarnOfField(state, key, luaL_typename(state, -1));
  }
}

struct PushValue {
  lua_State* state;
  void operator()(float number) const { lua_pushnumber(state, number); }
  void operator()(bool truth) const { lua_pushboolean(state, truth); }
  void operator()(const std::string& text) const { lua_pushlstring(state, text.data(), text.size()); }
  void operator()(world::Vec3 vector) const { PushVector(state, vector); }
  void operator()(Handle handle) const { PushHandle(state, handle); }
};

}  // namespace

ScriptEvent CopyEvent(lua_State* state, std::string_view type, int index) {
  ScriptEvent event{std::string(type), {}};
  if (!lua_istable(state, index)) {
    if (!lua_isnil(state, index)) WarnAtCaller(state, "the event is not a table: it is sent without fields");
    return event;
  }
  lua_pushnil(state);
  while (lua_next(state, index) != 0) {
    const int key_type = lua_type(state, -2);
    if (key_type == LUA_TSTRING || key_type == LUA_TNUMBER) {
      // Converts a copy of the key to text: converting the key itself would break lua_next.
      lua_pushvalue(state, -2);
      std::string key = lua_tostring(state, -1);
      lua_pop(state, 1);
      CopyField(state, std::move(key), event);
    }
    lua_pop(state, 1);
  }
  return event;
}

void PushEvent(lua_State* state, const ScriptEvent& event) {
  lua_newtable(state);
  for (const auto& [key, value] : event.fields) {
    lua_pushlstring(state, key.data(), key.size());
    std::visit(PushValue{state}, value);
    lua_rawset(state, -3);
  }
}

std::size_t SizeOf(const ScriptEvent& event) {
  std::size_t bytes = sizeof event + event.type.size();
  for (const auto& [key, value] : event.fields) {
    bytes += 100 + key.size();
    if (const auto* text = std::get_if<std::string>(&value)) bytes += text->size();
  }
  return bytes;
}

void EventQueue::Add(ScriptEvent event) {
  waiting_bytes_ += SizeOf(event);
  waiting_.push_back(std::move(event));
}

void EventQueue::Deliver(const Callbacks& listeners, const Callbacks::MayRun& may_run,
                         const Callbacks::OnResult& on_result) {
  const std::vector<ScriptEvent> events = std::exchange(waiting_, {});
  waiting_bytes_ = 0;
  for (const ScriptEvent& event : events) {
    listeners.CallAll(may_run, on_result, [&](lua_State* state, Handle listener) {
      PushSandbox(state);
      PushHandle(state, listener);
      lua_pushlstring(state, event.type.data(), event.type.size());
      PushEvent(state, event);
      return 4;
    });
  }
}

}  // namespace soarbox::script
