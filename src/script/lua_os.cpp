// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_os.h"

#include <array>
#include <cmath>
#include <ctime>
#include <lua.hpp>
#include <string_view>

#include "script/lua_machine.h"
#include "script/script_context.h"

namespace soarbox::script {
namespace {

/// Midnight of 1 January 2000, UTC, in seconds since 1970.
constexpr std::time_t kFirstMoment_s = 946'684'800;
/// Maximum distance from 1970: 30,000 years.
constexpr double kMostSeconds = 1e12;

/// The letters that are allowed after '%' in a date's format.
constexpr std::string_view kConversions = "aAbBcdHIjmMpSUwWxXyYZ%";

double SimulatedSeconds(lua_State* state) {
  const ScriptContext* context = LuaMachine::Of(state).context();
  return context != nullptr ? static_cast<double>(context->world.time_millis()) / 1000.0 : 0.0;
}

std::time_t Now(lua_State* state) {
  return kFirstMoment_s + static_cast<std::time_t>(SimulatedSeconds(state));
}

int Clock(lua_State* state) {
  lua_pushnumber(state, SimulatedSeconds(state));
  return 1;
}

/// A field of the table passed to os.time. If it is missing: `otherwise`, or an error if that is negative.
int Field(lua_State* state, const char* name, int otherwise) {
  lua_getfield(state, 1, name);
  const bool is_number = lua_isnumber(state, -1) != 0;
  const double value = lua_tonumber(state, -1);
  lua_pop(state, 1);
  if (!is_number && otherwise < 0) luaL_error(state, "field '%s' missing in date table", name);
  if (!is_number) return otherwise;
  if (!(std::fabs(value) < 1e9)) luaL_error(state, "field '%s' of the date table is out of range", name);
  return static_cast<int>(value);
}

int Time(lua_State* state) {
  if (lua_isnoneornil(state, 1)) {
    lua_pushnumber(state, static_cast<double>(Now(state)));
    return 1;
  }
  luaL_checktype(state, 1, LUA_TTABLE);
  std::tm parts{};
  parts.tm_sec = Field(state, "sec", 0);
  parts.tm_min = Field(state, "min", 0);
  parts.tm_hour = Field(state, "hour", 12);
  parts.tm_mday = Field(state, "day", -1);
  parts.tm_mon = Field(state, "month", -1) - 1;
  parts.tm_year = Field(state, "year", -1) - 1900;
  const auto seconds = static_cast<double>(timegm(&parts));
  if (std::fabs(seconds) > kMostSeconds) return luaL_error(state, "the time of this date is out of range");
  lua_pushnumber(state, seconds);
  return 1;
}

void PushParts(lua_State* state, const std::tm& parts) {
  lua_createtable(state, 0, 9);
  const auto set = [&](const char* name, int value) {
    lua_pushinteger(state, value);
    lua_setfield(state, -2, name);
  };
  set("sec", parts.tm_sec);
  set("min", parts.tm_min);
  set("hour", parts.tm_hour);
  set("day", parts.tm_mday);
  set("month", parts.tm_mon + 1);
  set("year", parts.tm_year + 1900);
  set("wday", parts.tm_wday + 1);
  set("yday", parts.tm_yday + 1);
  lua_pushboolean(state, 0);
  lua_setfield(state, -2, "isdst");
}

int Date(lua_State* state) {
  std::string_view format = luaL_optstring(state, 1, "%c");
  const double asked = lua_isnoneornil(state, 2) ? static_cast<double>(Now(state)) : luaL_checknumber(state, 2);
  luaL_argcheck(state, std::fabs(asked) <= kMostSeconds, 2, "time is out of range");
  const auto seconds = static_cast<std::time_t>(std::floor(asked));
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  // '!' requests UTC, which is the only time zone here.
  if (!format.empty() && format[0] == '!') format.remove_prefix(1);
  if (format.substr(0, 2) == "*t") {
    PushParts(state, parts);
    return 1;
  }
  luaL_Buffer text;
  luaL_buffinit(state, &text);
  for (std::size_t i = 0; i < format.size(); ++i) {
    if (format[i] != '%') {
      luaL_addchar(&text, format[i]);
      continue;
    }
    const char letter = i + 1 < format.size() ? format[++i] : '\0';
    if (letter == '\0' || kConversions.find(letter) == std::string_view::npos)
      return luaL_argerror(state, 1, "'%' is followed by a letter that no date has");
    const std::array<char, 3> conversion{'%', letter, '\0'};
    std::array<char, 100> written{};
    const std::size_t length = std::strftime(written.data(), written.size(), conversion.data(), &parts);
    luaL_addlstring(&text, written.data(), length);
  }
  luaL_pushresult(&text);
  return 1;
}

int DiffTime(lua_State* state) {
  lua_pushnumber(state, luaL_checknumber(state, 1) - luaL_optnumber(state, 2, 0));
  return 1;
}

int GetEnv(lua_State* state) {
  luaL_checkstring(state, 1);
  lua_pushnil(state);
  return 1;
}

int Exit(lua_State* state) {
  int code = 0;
  if (lua_isboolean(state, 1)) {
    code = lua_toboolean(state, 1) ? 0 : 1;
  } else {
    const double asked = luaL_optnumber(state, 1, 0);
    luaL_argcheck(state, std::fabs(asked) < 1e9, 1, "an exit code is a whole number");
    code = static_cast<int>(asked);
  }
  LuaMachine& machine = LuaMachine::Of(state);
  if (machine.world() != nullptr) machine.world()->EndScripts({machine.script(), code});
  machine.RaiseOutOfBudget(state);
  return 0;
}

}  // namespace

void InstallOs(lua_State* state) {
  lua_createtable(state, 0, 7);
  const auto set = [&](const char* name, lua_CFunction function) {
    lua_pushcfunction(state, function);
    lua_setfield(state, -2, name);
  };
  set("clock", Clock);
  set("time", Time);
  set("date", Date);
  set("difftime", DiffTime);
  set("getenv", GetEnv);
  set("exit", Exit);
  lua_setglobal(state, "os");
}

}  // namespace soarbox::script
