// SPDX-License-Identifier: BSD-2-Clause
#include "script/config_argument.h"

#include <lua.hpp>
#include <string>
#include <vector>

#include "script/argument_check.h"
#include "script/bind_arguments.h"
#include "script/binding.h"

namespace soarbox::script {
namespace {

/// Reads the value on top of the stack. May raise; the caller must not have C++ objects with destructors at that time.
void Take(lua_State* state, int index, const ConfigKey& key) {
  if (key.truth) {
    *key.truth = lua_toboolean(state, -1) != 0;
    return;
  }
  if (key.number && lua_isnumber(state, -1)) {
    *key.number = static_cast<float>(lua_tonumber(state, -1));
    return;
  }
  if (key.vector && ToVector(state, -1)) {
    *key.vector = *ToVector(state, -1);
    return;
  }
  ArgumentError(state, index,
                lua_pushfstring(state, "%s must be a %s, not a %s", key.name, key.number ? "number" : "Vector",
                                NameOfValue(state, -1)));
}

void WarnOfKey(lua_State* state, std::initializer_list<ConfigKey> keys) {
  // A copy: lua_tostring would convert the key itself to a string, which breaks lua_next.
  const std::string name = lua_type(state, -2) == LUA_TSTRING ? lua_tostring(state, -2) : luaL_typename(state, -2);
  std::vector<std::string_view> known;
  for (const ConfigKey& key : keys) known.emplace_back(key.name);
  const std::string_view meant = Suggest(name, known);
  const std::string hint = meant.empty() ? "" : ", did you mean \"" + std::string(meant) + "\"?";
  WarnAtCaller(state, "there is no setting \"" + name + "\"" + hint);
}

}  // namespace

void ReadConfig(lua_State* state, int index, std::initializer_list<ConfigKey> keys) {
  if (lua_isnoneornil(state, index)) return;
  luaL_checktype(state, index, LUA_TTABLE);
  lua_pushnil(state);
  while (lua_next(state, index) != 0) {
    const ConfigKey* found = nullptr;
    if (lua_type(state, -2) == LUA_TSTRING) {
      const std::string_view name = lua_tostring(state, -2);
      for (const ConfigKey& key : keys) {
        if (name == key.name) found = &key;
      }
    }
    if (found) {
      Take(state, index, *found);
    } else {
      WarnOfKey(state, keys);
    }
    lua_pop(state, 1);
  }
}

world::Color ColorArgument(lua_State* state, int index) {
  luaL_checktype(state, index, LUA_TTABLE);
  float channels[4] = {0, 0, 0, 0};
  for (int i = 0; i < 4; ++i) {
    lua_rawgeti(state, index, i + 1);
    if (lua_isnumber(state, -1)) {
      channels[i] = static_cast<float>(lua_tonumber(state, -1));
    } else {
      WarnAtCaller(state, "a colour is a table of four numbers, red, green, blue and alpha: other values count as 0");
    }
    lua_pop(state, 1);
  }
  return {channels[0], channels[1], channels[2], channels[3]};
}

int RaiseDiagnostic(lua_State* state, const Diagnostic& error) {
  luaL_where(state, 1);
  lua_pushlstring(state, error.message.data(), error.message.size());
  if (error.hint.empty()) {
    lua_concat(state, 2);
  } else {
    lua_pushliteral(state, " (");
    lua_pushlstring(state, error.hint.data(), error.hint.size());
    lua_pushliteral(state, ")");
    lua_concat(state, 5);
  }
  return lua_error(state);
}

}  // namespace soarbox::script
