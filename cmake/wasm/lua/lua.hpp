// SPDX-License-Identifier: BSD-2-Clause
#pragma once

// Lua 5.1, compiled as C++, with what src/script uses of LuaJIT besides.

#include <cstddef>

#include "lauxlib.h"
#include "lua.h"
#include "lualib.h"

#define LUA_BITLIBNAME "bit"
constexpr int LUAJIT_MODE_ENGINE = 0, LUAJIT_MODE_OFF = 0;

/// Lua 5.1 compiles nothing while it runs.
inline int luaJIT_setmode(lua_State*, int, int) {
  return 1;
}

/// luaL_loadbuffer for text ("t"), compiled chunks ("b") or both ("bt" or null).
int luaL_loadbufferx(lua_State* state, const char* text, std::size_t length, const char* name, const char* mode);

/// The library `bit`: operations on 32-bit integers.
int luaopen_bit(lua_State* state);
