// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_guarded.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <lua.hpp>

#include "script/lua_machine.h"
#include "script/nested_call.h"

namespace soarbox::script {

NestedCall::NestedCall(lua_State* state) : machine_(LuaMachine::Of(state)) {
  constexpr int kMostNested = 150;
  if (machine_.nested_calls_ >= kMostNested)
    luaL_error(state, "too many calls of built-in functions within each other");
  ++machine_.nested_calls_;
}

namespace {

/// Bytes or table slots moved in the time of one instruction.
constexpr std::uint64_t kMovedPerInstruction = 32;

/// Charges the budget for work before it is done; raises an error if the budget is too small.
void ChargeFor(lua_State* state, double work) {
  if (work <= 0) return;
  const std::uint64_t price = work < 1e18 ? static_cast<std::uint64_t>(work) : std::uint64_t{1} << 60;
  LuaMachine::Of(state).ChargeOrRaise(state, price);
}

/// Calls the built-in function (upvalue 1) with all arguments and returns all of its results.
int CallBuiltIn(lua_State* state) {
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, LUA_MULTRET);
  return lua_gettop(state);
}

int CallNested(lua_State* state) {
  const NestedCall nested(state);
  return CallBuiltIn(state);
}

/// Total bytes of the strings among the first `count` elements of the table at index 1. A string may occur many times.
double TextBytes(lua_State* state, std::uint64_t count) {
  double bytes = 0;
  for (std::uint64_t i = 1; i <= count; ++i) {
    lua_rawgeti(state, 1, static_cast<int>(i));
    if (lua_type(state, -1) == LUA_TSTRING) bytes += static_cast<double>(lua_objlen(state, -1));
    lua_pop(state, 1);
  }
  return bytes;
}

int Sort(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  const auto count = static_cast<std::uint64_t>(lua_objlen(state, 1));
  ChargeFor(state, static_cast<double>(count) * std::bit_width(count));
  // Long strings are compared byte by byte.
  ChargeFor(state, TextBytes(state, count) / kMovedPerInstruction * std::bit_width(count));
  return CallNested(state);
}

/// The price of moving all elements from a position to the end. Positions before the first element are not in the
/// array, so each of them is looked up.
double MovePrice(double size, double position) {
  constexpr double kPerLookUp = 8;
  const double first = std::max(position, 1.0);
  return std::max(size - first, 0.0) / kMovedPerInstruction + std::max(1.0 - position, 0.0) * kPerLookUp;
}

int Insert(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  const int size = static_cast<int>(lua_objlen(state, 1));
  if (lua_gettop(state) == 2) {
    lua_rawseti(state, 1, size + 1);
    return 0;
  }
  if (lua_gettop(state) != 3) return luaL_error(state, "wrong number of arguments to 'insert'");
  ChargeFor(state, MovePrice(size, luaL_checknumber(state, 2)));
  return CallBuiltIn(state);
}

int GuardedRemove(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  const auto size = static_cast<double>(lua_objlen(state, 1));
  ChargeFor(state, MovePrice(size, luaL_optnumber(state, 2, std::max(size, 1.0))));
  return CallBuiltIn(state);
}

/// For functions that visit an entire table.
int WalkTable(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  ChargeFor(state, static_cast<double>(lua_objlen(state, 1)) / 4);
  return CallNested(state);
}

/// table.concat: charges for the bytes that it copies, up to the memory limit.
int Concat(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  const auto count = static_cast<std::uint64_t>(lua_objlen(state, 1));
  ChargeFor(state, static_cast<double>(count) / 4);
  const double between = lua_type(state, 2) == LUA_TSTRING ? static_cast<double>(lua_objlen(state, 2)) : 0;
  const double most = static_cast<double>(LuaMachine::Of(state).memory().limit_bytes());
  const double bytes = TextBytes(state, count) + between * static_cast<double>(count);
  ChargeFor(state, std::min(bytes, most) / kMovedPerInstruction);
  return CallNested(state);
}

/// table.maxn: visits every element, also outside of the array part.
int LargestNumber(lua_State* state) {
  luaL_checktype(state, 1, LUA_TTABLE);
  constexpr std::uint64_t kPayEvery = 1024;
  double largest = 0;
  std::uint64_t seen = 0;
  for (lua_pushnil(state); lua_next(state, 1) != 0; lua_pop(state, 1)) {
    if (lua_type(state, -2) == LUA_TNUMBER) largest = std::max(largest, static_cast<double>(lua_tonumber(state, -2)));
    if (++seen % kPayEvery == 0) ChargeFor(state, kPayEvery);
  }
  lua_pushnumber(state, largest);
  return 1;
}

int Repeat(lua_State* state) {
  std::size_t length = 0;
  luaL_checklstring(state, 1, &length);
  const lua_Number count = luaL_checknumber(state, 2);
  // Repeating an empty string gives an empty string; the built-in function would still count up.
  if (length == 0 && lua_gettop(state) < 3) {
    lua_pushliteral(state, "");
    return 1;
  }
  // A result above the memory limit costs no more than one at the limit, because it fails at once.
  const double most = static_cast<double>(LuaMachine::Of(state).memory().limit_bytes());
  const std::size_t between = lua_type(state, 3) == LUA_TSTRING ? lua_objlen(state, 3) : 0;
  ChargeFor(state, std::min(static_cast<double>(length + between + 1) * count, most) / kMovedPerInstruction);
  return CallBuiltIn(state);
}

/// For functions that read an entire string.
int WalkText(lua_State* state) {
  std::size_t length = 0;
  luaL_checklstring(state, 1, &length);
  ChargeFor(state, static_cast<double>(length) / kMovedPerInstruction);
  return CallBuiltIn(state);
}

/// coroutine.wrap: the returned function is guarded too.
int Wrap(lua_State* state) {
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, 1);
  lua_pushcclosure(state, CallNested, 1);
  return 1;
}

struct Guard {
  const char* table;
  const char* name;
  lua_CFunction function;
};

constexpr Guard kGuards[] = {
    {"table", "sort", Sort},       {"table", "insert", Insert},         {"table", "remove", GuardedRemove},
    {"table", "concat", Concat},   {"table", "maxn", LargestNumber},    {"table", "foreachi", WalkTable},
    {"string", "rep", Repeat},     {"string", "reverse", WalkText},     {"string", "upper", WalkText},
    {"string", "lower", WalkText}, {"coroutine", "resume", CallNested}, {"coroutine", "wrap", Wrap},
};

}  // namespace

void InstallGuards(lua_State* state) {
  for (const Guard& guard : kGuards) {
    lua_getglobal(state, guard.table);
    lua_getfield(state, -1, guard.name);
    if (lua_isfunction(state, -1)) {
      lua_pushcclosure(state, guard.function, 1);
      lua_setfield(state, -2, guard.name);
      lua_pop(state, 1);
    } else {
      lua_pop(state, 2);
    }
  }
}

}  // namespace soarbox::script
