// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_order.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <lua.hpp>

#include "script/lua_machine.h"
#include "script/nested_call.h"
#include "script/script_memory.h"

namespace soarbox::script {
namespace {

/// Cost of ranking a key, in instructions.
constexpr std::uint64_t kPricePerKey = 8;

/// The sort key of a table's key. Text points into a string that the table keeps alive.
struct KeyRank {
  int group = 0;  // 0 numbers, 1 strings, 2 booleans, 3 objects.
  double number = 0;
  const char* text = nullptr;
  std::size_t length = 0;
  std::uint64_t made = 0;
  int position = 0;
};

bool operator<(const KeyRank& a, const KeyRank& b) {
  if (a.group != b.group) return a.group < b.group;
  if (a.group == 1) {
    const int order = std::memcmp(a.text, b.text, std::min(a.length, b.length));
    return order != 0 ? order < 0 : a.length < b.length;
  }
  return a.group == 3 ? a.made < b.made : a.number < b.number;
}

KeyRank RankOf(lua_State* state, int index) {
  KeyRank rank;
  switch (lua_type(state, index)) {
    case LUA_TNUMBER:
      rank.number = lua_tonumber(state, index);
      break;
    case LUA_TSTRING:
      rank.group = 1;
      rank.text = lua_tolstring(state, index, &rank.length);
      break;
    case LUA_TBOOLEAN:
      rank.group = 2;
      rank.number = lua_toboolean(state, index);
      break;
    default:
      rank.group = 3;
      rank.made = LuaMachine::Of(state).memory().OrderOf(lua_topointer(state, index));
  }
  return rank;
}

/// next(table [, key]): the smallest key above the given one. Visits the entire table each time; `pairs` does not.
int Next(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  lua_settop(state, 2);
  const bool from_start = lua_isnil(state, 2);
  const KeyRank after = from_start ? KeyRank{} : RankOf(state, 2);

  // Slots 3 and 4: the best key so far and its value.
  lua_pushnil(state);
  lua_pushnil(state);
  KeyRank best;
  bool found = false;
  std::uint64_t looked_at = 0;
  lua_pushnil(state);
  while (lua_next(state, 1) != 0) {
    ++looked_at;
    const KeyRank rank = RankOf(state, -2);
    if ((from_start || after < rank) && (!found || rank < best)) {
      found = true;
      best = rank;
      lua_pushvalue(state, -2);
      lua_replace(state, 3);
      lua_pushvalue(state, -1);
      lua_replace(state, 4);
    }
    lua_pop(state, 1);
  }
  LuaMachine::Of(state).ChargeOrRaise(state, looked_at * kPricePerKey);
  lua_settop(state, 4);
  return found ? 2 : 1;
}

/// The step of a pairs loop. Upvalues: the ordered keys, the number of visited keys. Argument 1: the table.
int NextOfPairs(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  int visited = static_cast<int>(lua_tointeger(state, lua_upvalueindex(2)));
  while (true) {
    ++visited;
    lua_rawgeti(state, lua_upvalueindex(1), visited);
    if (lua_isnil(state, -1)) return 1;
    lua_pushvalue(state, -1);
    lua_rawget(state, 1);
    if (!lua_isnil(state, -1)) break;
    lua_pop(state, 2);
  }
  lua_pushinteger(state, visited);
  lua_replace(state, lua_upvalueindex(2));
  return 2;
}

int Pairs(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  PushOrderedKeys(state, 1);
  lua_pushinteger(state, 0);
  lua_pushcclosure(state, NextOfPairs, 2);
  lua_pushvalue(state, 1);
  lua_pushnil(state);
  return 3;
}

int ForEach(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  luaL_checktype(state, 2, LUA_TFUNCTION);
  const NestedCall nested(state);
  lua_settop(state, 2);
  PushOrderedKeys(state, 1);
  for (int i = 1;; ++i) {
    lua_settop(state, 3);
    lua_rawgeti(state, 3, i);
    if (lua_isnil(state, -1)) return 0;
    lua_pushvalue(state, 2);
    lua_pushvalue(state, 4);
    lua_pushvalue(state, 4);
    lua_rawget(state, 1);
    lua_call(state, 2, 1);
    if (!lua_isnil(state, -1)) return 1;
  }
}

}  // namespace

bool IsPlainArray(lua_State* state, int index, int& count) {
  if (index < 0) index = lua_gettop(state) + index + 1;
  count = 0;
  lua_pushnil(state);
  while (lua_next(state, index) != 0) {
    lua_pop(state, 1);
    if (lua_type(state, -1) == LUA_TNUMBER && lua_tonumber(state, -1) == ++count) continue;
    lua_pop(state, 1);
    return false;
  }
  return true;
}

void PushOrderedKeys(lua_State* state, int index) {
  if (index < 0) index = lua_gettop(state) + index + 1;
  luaL_checkstack(state, 8, "too many nested calls");
  int count = 0;
  bool is_array = true;  // The keys already come in the order 1, 2, 3, ...: the common case, which needs no sorting.
  lua_newtable(state);
  const int keys = lua_gettop(state);
  lua_pushnil(state);
  while (lua_next(state, index) != 0) {
    lua_pop(state, 1);
    lua_pushvalue(state, -1);
    lua_rawseti(state, keys, ++count);
    if (is_array && !(lua_type(state, -1) == LUA_TNUMBER && lua_tonumber(state, -1) == count)) is_array = false;
  }
  LuaMachine::Of(state).ChargeOrRaise(state, static_cast<std::uint64_t>(count) * (is_array ? 1 : kPricePerKey));
  if (is_array) return;

  auto* ranks = static_cast<KeyRank*>(lua_newuserdata(state, sizeof(KeyRank) * static_cast<std::size_t>(count)));
  for (int i = 0; i < count; ++i) {
    lua_rawgeti(state, keys, i + 1);
    ranks[i] = RankOf(state, -1);
    ranks[i].position = i + 1;
    lua_pop(state, 1);
  }
  std::sort(ranks, ranks + count);
  lua_createtable(state, count, 0);
  for (int i = 0; i < count; ++i) {
    lua_rawgeti(state, keys, ranks[i].position);
    lua_rawseti(state, -2, i + 1);
  }
  lua_replace(state, keys);
  lua_settop(state, keys);
}

void InstallOrder(lua_State* state) {
  lua_pushcfunction(state, Pairs);
  lua_setglobal(state, "pairs");
  lua_pushcfunction(state, Next);
  lua_setglobal(state, "next");
  lua_getglobal(state, "table");
  lua_pushcfunction(state, ForEach);
  lua_setfield(state, -2, "foreach");
  lua_pop(state, 1);
}

}  // namespace soarbox::script
