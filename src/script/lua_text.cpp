// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_text.h"

#include <cstdio>
#include <cstring>
#include <lua.hpp>

#include "script/nested_call.h"

namespace soarbox::script {
namespace {

// Registry keys; only their addresses are used.
char names_key;
char count_key;

/// Pushes the number of the object at `index`; an object without a number gets the next one.
void PushNumberOf(lua_State* state, int index) {
  lua_pushlightuserdata(state, &names_key);
  lua_rawget(state, LUA_REGISTRYINDEX);
  lua_pushvalue(state, index);
  lua_rawget(state, -2);
  if (lua_isnil(state, -1)) {
    lua_pop(state, 1);
    lua_pushlightuserdata(state, &count_key);
    lua_rawget(state, LUA_REGISTRYINDEX);
    const lua_Number number = lua_tonumber(state, -1) + 1;
    lua_pop(state, 1);
    lua_pushlightuserdata(state, &count_key);
    lua_pushnumber(state, number);
    lua_rawset(state, LUA_REGISTRYINDEX);
    lua_pushvalue(state, index);
    lua_pushnumber(state, number);
    lua_rawset(state, -3);
    lua_pushnumber(state, number);
  }
  lua_remove(state, -2);
}

int ToString(lua_State* state) {
  luaL_checkany(state, 1);
  PushText(state, 1);
  return 1;
}

/// string.format that formats objects itself, because the built-in one prints their addresses.
int FormatText(lua_State* state) {
  std::size_t length = 0;
  const char* format = luaL_checklstring(state, 1, &length);
  const char* end = format + length;
  int argument = 1;
  for (const char* at = format; at < end; ++at) {
    if (*at != '%') continue;
    if (++at >= end) break;
    if (*at == '%') continue;
    while (at < end && std::strchr("-+ #0123456789.", *at)) ++at;
    if (at >= end) break;
    ++argument;
    if (*at == 'p') return luaL_argerror(state, 1, "%p is not available: addresses differ from run to run");
    if (*at != 's' || argument > lua_gettop(state)) continue;
    const int type = lua_type(state, argument);
    if (type == LUA_TSTRING || type == LUA_TNUMBER) continue;
    PushText(state, argument);
    lua_replace(state, argument);
  }
  lua_pushvalue(state, lua_upvalueindex(1));
  lua_insert(state, 1);
  lua_call(state, lua_gettop(state) - 1, 1);
  return 1;
}

}  // namespace

void PushText(lua_State* state, int index) {
  if (index < 0) index = lua_gettop(state) + index + 1;
  if (luaL_getmetafield(state, index, "__tostring")) {
    const NestedCall nested(state);
    lua_pushvalue(state, index);
    lua_call(state, 1, 1);
    return;
  }
  switch (lua_type(state, index)) {
    case LUA_TSTRING:
      lua_pushvalue(state, index);
      return;
    case LUA_TNUMBER:
      lua_pushvalue(state, index);
      lua_tostring(state, -1);
      return;
    case LUA_TBOOLEAN:
      lua_pushstring(state, lua_toboolean(state, index) ? "true" : "false");
      return;
    case LUA_TNIL:
      lua_pushliteral(state, "nil");
      return;
    default:
      break;
  }
  PushNumberOf(state, index);
  char text[48];
  std::snprintf(text, sizeof text, "%s: 0x%08x", luaL_typename(state, index),
                static_cast<unsigned>(lua_tonumber(state, -1)));
  lua_pop(state, 1);
  lua_pushstring(state, text);
}

std::string DisplayText(lua_State* state, int index) {
  switch (lua_type(state, index)) {
    case LUA_TSTRING: {
      std::size_t length = 0;
      const char* text = lua_tolstring(state, index, &length);
      return {text, length};
    }
    case LUA_TNUMBER: {
      char text[40];
      std::snprintf(text, sizeof text, "%.14g", lua_tonumber(state, index));
      return text;
    }
    default:
      return std::string("the error is a ") + luaL_typename(state, index) + " value";
  }
}

void InstallText(lua_State* state) {
  lua_pushlightuserdata(state, &names_key);
  lua_newtable(state);
  lua_newtable(state);
  lua_pushliteral(state, "k");
  lua_setfield(state, -2, "__mode");
  lua_setmetatable(state, -2);
  lua_rawset(state, LUA_REGISTRYINDEX);

  lua_pushcfunction(state, ToString);
  lua_setglobal(state, "tostring");

  lua_getglobal(state, "string");
  lua_getfield(state, -1, "format");
  lua_pushcclosure(state, FormatText, 1);
  lua_setfield(state, -2, "format");
  lua_pop(state, 1);
}

}  // namespace soarbox::script
