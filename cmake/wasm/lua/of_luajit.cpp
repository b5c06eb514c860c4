// SPDX-License-Identifier: BSD-2-Clause
// What scripts and src/script know from LuaJIT and Lua 5.1 does not have.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "lua.hpp"

namespace {

using Bits = std::uint32_t;

/// A number as LuaJIT's bit library takes it: rounded to the nearest integer, modulo 2^32.
Bits Argument(lua_State* state, int index) {
  const double whole = std::nearbyint(luaL_checknumber(state, index));
  const double rest = std::fmod(whole, 4294967296.0);
  return std::isfinite(rest) ? static_cast<Bits>(static_cast<std::int64_t>(rest)) : 0;
}

int Return(lua_State* state, Bits bits) {
  lua_pushnumber(state, static_cast<double>(static_cast<std::int32_t>(bits)));
  return 1;
}

template <typename Operation>
int Fold(lua_State* state, Operation operation) {
  Bits bits = Argument(state, 1);
  for (int i = 2; i <= lua_gettop(state); ++i) bits = operation(bits, Argument(state, i));
  return Return(state, bits);
}

template <typename Operation>
int Shift(lua_State* state, Operation operation) {
  return Return(state, operation(Argument(state, 1), Argument(state, 2) & 31));
}

Bits RotatedLeft(Bits bits, Bits by) {
  return by == 0 ? bits : bits << by | bits >> (32 - by);
}

int ToBit(lua_State* state) {
  return Return(state, Argument(state, 1));
}
int BitNot(lua_State* state) {
  return Return(state, ~Argument(state, 1));
}
int BitAnd(lua_State* state) {
  return Fold(state, [](Bits a, Bits b) { return a & b; });
}
int BitOr(lua_State* state) {
  return Fold(state, [](Bits a, Bits b) { return a | b; });
}
int BitXor(lua_State* state) {
  return Fold(state, [](Bits a, Bits b) { return a ^ b; });
}
int ShiftLeft(lua_State* state) {
  return Shift(state, [](Bits bits, Bits by) { return bits << by; });
}
int ShiftRight(lua_State* state) {
  return Shift(state, [](Bits bits, Bits by) { return bits >> by; });
}
int ShiftRightSigned(lua_State* state) {
  return Shift(state, [](Bits bits, Bits by) { return static_cast<Bits>(static_cast<std::int32_t>(bits) >> by); });
}
int RotateLeft(lua_State* state) {
  return Shift(state, RotatedLeft);
}
int RotateRight(lua_State* state) {
  return Shift(state, [](Bits bits, Bits by) { return RotatedLeft(bits, (32 - by) & 31); });
}
int SwapBytes(lua_State* state) {
  const Bits bits = Argument(state, 1);
  return Return(state, bits >> 24 | (bits >> 8 & 0xff00) | (bits << 8 & 0xff0000) | bits << 24);
}

/// tohex(x [, digits]): 8 digits by default; a negative number of digits gives capital letters.
int ToHex(lua_State* state) {
  Bits bits = Argument(state, 1);
  const std::int32_t wanted = lua_isnoneornil(state, 2) ? 8 : static_cast<std::int32_t>(Argument(state, 2));
  const char* const digits = wanted < 0 ? "0123456789ABCDEF" : "0123456789abcdef";
  const int count = wanted < -8 || wanted > 8 ? 8 : wanted < 0 ? -wanted : wanted;
  char text[8];
  for (int i = count; i > 0; bits >>= 4) text[--i] = digits[bits & 15];
  lua_pushlstring(state, text, static_cast<std::size_t>(count));
  return 1;
}

constexpr luaL_Reg kFunctions[] = {
    {"tobit", ToBit},    {"bnot", BitNot},      {"band", BitAnd},       {"bor", BitOr},
    {"bxor", BitXor},    {"lshift", ShiftLeft}, {"rshift", ShiftRight}, {"arshift", ShiftRightSigned},
    {"rol", RotateLeft}, {"ror", RotateRight},  {"bswap", SwapBytes},   {"tohex", ToHex},
    {nullptr, nullptr}};

}  // namespace

int luaL_loadbufferx(lua_State* state, const char* text, std::size_t length, const char* name, const char* mode) {
  const bool is_compiled = length > 0 && text[0] == LUA_SIGNATURE[0];
  if (mode != nullptr && std::strchr(mode, is_compiled ? 'b' : 't') == nullptr) {
    lua_pushfstring(state, "attempt to load %s chunk (mode is '%s')", is_compiled ? "a compiled" : "a text", mode);
    return LUA_ERRSYNTAX;
  }
  return luaL_loadbuffer(state, text, length, name);
}

int luaopen_bit(lua_State* state) {
  luaL_register(state, LUA_BITLIBNAME, kFunctions);
  return 1;
}
