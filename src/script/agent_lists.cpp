// SPDX-License-Identifier: BSD-2-Clause
#include "script/agent_lists.h"

#include <cstring>
#include <lua.hpp>

#include "script/lua_machine.h"
#include "script/lua_values.h"

namespace soarbox::script {
namespace {

/// LuaJIT keeps shorter arrays elsewhere.
constexpr std::size_t kShortest = 32;
constexpr std::size_t kElement_bytes = 8;

/// The block also has an element with index 0.
std::size_t BlockSize(std::size_t count) {
  return (count + 1) * kElement_bytes;
}

/// Compares the ids as one block of memory.
bool AreSame(std::span<const world::EntityId> a, std::span<const world::EntityId> b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

void Fill(lua_State* state, std::span<const world::EntityId> ids) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    PushAgent(state, ids[i]);
    lua_rawseti(state, -2, static_cast<int>(i + 1));
  }
}

}  // namespace

void* AgentLists::BlockOfNewArray(LuaMachine& machine, std::size_t count) {
  const auto [block, size] = machine.memory().last_block();
  return size == BlockSize(count) ? block : nullptr;
}

void AgentLists::MakeTemplate(lua_State* state, std::span<const world::EntityId> ids) {
  template_block_ = nullptr;
  if (template_ != 0) luaL_unref(state, LUA_REGISTRYINDEX, template_);
  template_ = 0;
  lua_createtable(state, static_cast<int>(ids.size()), 0);
  const void* const block = BlockOfNewArray(LuaMachine::Of(state), ids.size());
  Fill(state, ids);
  template_ = luaL_ref(state, LUA_REGISTRYINDEX);
  ids_.assign(ids.begin(), ids.end());
  template_block_ = block;
}

void AgentLists::Push(lua_State* state, std::span<const world::EntityId> ids) {
  const bool is_long = ids.size() >= kShortest;
  if (is_long && (template_ == 0 || !AreSame(ids, ids_))) MakeTemplate(state, ids);
  lua_createtable(state, static_cast<int>(ids.size()), 0);
  LuaMachine& machine = LuaMachine::Of(state);
  void* const block = is_long && template_block_ != nullptr ? BlockOfNewArray(machine, ids.size()) : nullptr;
  if (block == nullptr) return Fill(state, ids);
  // The handles are alive, because the template holds them; the collector never runs in the middle of a call.
  std::memcpy(block, template_block_, BlockSize(ids.size()));
  last_ = lua_topointer(state, -1);
  machine.memory().Watch(block);
}

bool AgentLists::Holds(lua_State* state, int index, std::span<const world::EntityId> ids) const {
  const void* const block = LuaMachine::Of(state).memory().watched();
  if (block == nullptr || lua_topointer(state, index) != last_ || !AreSame(ids, ids_)) return false;
  if (std::memcmp(block, template_block_, BlockSize(ids.size())) != 0) return false;
  // The table must not contain anything else.
  lua_pushinteger(state, static_cast<lua_Integer>(ids.size()));
  if (lua_next(state, index) == 0) return true;
  lua_pop(state, 2);
  return false;
}

}  // namespace soarbox::script
