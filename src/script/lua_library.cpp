// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_library.h"

#include <cmath>
#include <lua.hpp>
#include <string>

#include "script/lua_guarded.h"
#include "script/lua_machine.h"
#include "script/lua_order.h"
#include "script/lua_os.h"
#include "script/lua_pattern.h"
#include "script/lua_text.h"
#include "script/nested_call.h"
#include "script/script_error.h"
#include "script/script_path.h"

namespace soarbox::script {
namespace {

int Print(lua_State* state) {
  const NestedCall nested(state);
  const int count = lua_gettop(state);
  luaL_Buffer line;
  luaL_buffinit(state, &line);
  for (int i = 1; i <= count; ++i) {
    if (i > 1) luaL_addchar(&line, '\t');
    PushText(state, i);
    luaL_addvalue(&line);
  }
  luaL_pushresult(&line);
  std::size_t length = 0;
  const char* text = lua_tolstring(state, -1, &length);
  LuaMachine& machine = LuaMachine::Of(state);
  machine.Charge(100);
  machine.print().OnPrint(machine.script(), {text, length});
  return 0;
}

/// Lua 5.1's rule: limits are truncated to integers first, so random(5.95, 8.05) returns 5 to 8.
int Random(lua_State* state) {
  const int count = lua_gettop(state);
  if (count > 2) return luaL_error(state, "wrong number of arguments");
  double low = 1, high = 0;
  if (count == 1) high = std::trunc(luaL_checknumber(state, 1));
  if (count == 2) {
    low = std::trunc(luaL_checknumber(state, 1));
    high = std::trunc(luaL_checknumber(state, 2));
  }
  if (count > 0) luaL_argcheck(state, low <= high, count, "interval is empty");
  const double unit = LuaMachine::Of(state).random().Unit();
  lua_pushnumber(state, count == 0 ? unit : std::floor(unit * (high - low + 1)) + low);
  return 1;
}

int RandomSeed(lua_State* state) {
  const double number = luaL_checknumber(state, 1);
  const bool fits = std::fabs(number) < 9e18;
  LuaMachine::Of(state).random().Reseed(fits ? static_cast<std::int64_t>(number) : 0);
  return 0;
}

/// load and loadstring for source text only, because bytecode could crash the machine.
int LoadText(lua_State* state) {
  std::size_t length = 0;
  const char* text = luaL_checklstring(state, 1, &length);
  const char* name = luaL_optstring(state, 2, text);
  if (luaL_loadbufferx(state, text, length, name, "t") == 0) return 1;
  lua_pushnil(state);
  lua_insert(state, -2);
  return 2;
}

int Load(lua_State* state) {
  if (lua_type(state, 1) == LUA_TSTRING) return LoadText(state);
  luaL_checktype(state, 1, LUA_TFUNCTION);
  const NestedCall nested(state);
  lua_settop(state, 2);
  luaL_Buffer text;
  luaL_buffinit(state, &text);
  while (true) {
    lua_pushvalue(state, 1);
    lua_call(state, 0, 1);
    const bool end = lua_isnil(state, -1) || (lua_isstring(state, -1) && lua_objlen(state, -1) == 0);
    if (!end && !lua_isstring(state, -1)) return luaL_error(state, "reader function must return a string");
    if (end) break;
    luaL_addvalue(&text);
  }
  lua_pop(state, 1);
  luaL_pushresult(&text);
  lua_replace(state, 1);
  if (lua_isnil(state, 2)) {
    lua_pushliteral(state, "=(load)");
    lua_replace(state, 2);
  }
  return LoadText(state);
}

int CollectGarbage(lua_State* state) {
  const char* what = luaL_optstring(state, 1, "collect");
  if (std::string_view(what) == "count")
    return luaL_argerror(state, 1, "the amount of memory is not available: it can differ from run to run");
  if (std::string_view(what) == "collect") LuaMachine::Of(state).CollectGarbage();
  lua_pushinteger(state, 0);
  return 1;
}

/// Ends the loading of a module in every case: Lua's errors run destructors.
struct LoadingMark {
  LuaMachine& machine;
  const std::string& module;
  ~LoadingMark() { machine.EndLoading(module); }
};

/// require(name): runs <name>.lua of the search path once per machine. Returns nothing, as in the original sandbox.
int Require(lua_State* state) {
  if (lua_gettop(state) != 1) return 0;
  const std::string name = luaL_checkstring(state, 1);
  lua_getfield(state, LUA_REGISTRYINDEX, "_LOADED");
  lua_getfield(state, 2, name.c_str());
  if (lua_toboolean(state, -1)) return 0;
  lua_pop(state, 1);

  LuaMachine& machine = LuaMachine::Of(state);
  const std::string file = name + ".lua";
  const Result<const ScriptSource*> source = machine.path().Load(file);
  if (!source.ok()) {
    const Diagnostic& error = source.error();
    const std::string hint = error.hint.empty() ? "" : " (" + error.hint + ")";
    return luaL_error(state, "%s%s", error.message.c_str(), hint.c_str());
  }
  if (!machine.BeginLoading(name))
    return luaL_error(state, "module '%s' requires itself, directly or through others", name.c_str());
  machine.NoteFile(file);
  const LoadingMark mark{machine, name};
  const NestedCall nested(state);
  RunSource(state, *source.value(), file);
  lua_pushboolean(state, 1);
  lua_setfield(state, 2, name.c_str());
  return 0;
}

/// debug.traceback([message]): the current calls, innermost first. The rest of Lua's debug library is missing.
int DebugTraceback(lua_State* state) {
  const NestedCall nested(state);
  const bool has_message = !lua_isnoneornil(state, 1);
  if (has_message &&
      !lua_isstring(state, 1)) {  // As in Lua, an error object that is not a string is returned unchanged.
    lua_settop(state, 1);
    return 1;
  }
  std::string text = has_message ? std::string(lua_tostring(state, 1)) + "\n" : std::string();
  text += "called from:\n" + Traceback(state);
  if (text.ends_with('\n')) text.pop_back();
  LuaMachine::Of(state).Charge(text.size());
  lua_pushlstring(state, text.data(), text.size());
  return 1;
}

/// xpcall that runs its handler after the failed call is unwound. The built-in one runs it during the failed call,
/// where instructions are not counted, so a handler could loop forever. Scripts cannot see the difference, because they
/// have no debug library.
constexpr std::string_view kXpcall = R"(
local pcall = pcall
local function finish(handler, ok, ...)
  if ok then return true, ... end
  local _, result = pcall(handler, ...)
  return false, result
end
function xpcall(f, handler, ...)
  return finish(handler, pcall(f, ...))
end
)";

void Open(lua_State* state, lua_CFunction open, const char* name) {
  lua_pushcfunction(state, open);
  lua_pushstring(state, name);
  lua_call(state, 1, 0);
}

void SetGlobal(lua_State* state, const char* name, lua_CFunction function) {
  lua_pushcfunction(state, function);
  lua_setglobal(state, name);
}

void RemoveField(lua_State* state, const char* table, const char* field) {
  lua_getglobal(state, table);
  lua_pushnil(state);
  lua_setfield(state, -2, field);
  lua_pop(state, 1);
}

}  // namespace

void InstallLibrary(lua_State* state) {
  Open(state, luaopen_base, "");
  Open(state, luaopen_table, LUA_TABLIBNAME);
  Open(state, luaopen_string, LUA_STRLIBNAME);
  Open(state, luaopen_math, LUA_MATHLIBNAME);
  Open(state, luaopen_bit, LUA_BITLIBNAME);
  for (const char* name : {"dofile", "loadfile", "newproxy", "gcinfo", "module"}) {
    lua_pushnil(state);
    lua_setglobal(state, name);
  }
  RemoveField(state, "string", "dump");

  SetGlobal(state, "print", Print);
  SetGlobal(state, "load", Load);
  SetGlobal(state, "loadstring", LoadText);
  SetGlobal(state, "collectgarbage", CollectGarbage);
  SetGlobal(state, "require", Require);

  lua_getglobal(state, "math");
  lua_pushcfunction(state, Random);
  lua_setfield(state, -2, "random");
  lua_pushcfunction(state, RandomSeed);
  lua_setfield(state, -2, "randomseed");
  lua_pop(state, 1);

  // package only contains the list of loaded modules.
  lua_newtable(state);
  lua_getfield(state, LUA_REGISTRYINDEX, "_LOADED");
  lua_setfield(state, -2, "loaded");
  lua_setglobal(state, "package");

  lua_createtable(state, 0, 1);
  lua_pushcfunction(state, DebugTraceback);
  lua_setfield(state, -2, "traceback");
  lua_setglobal(state, "debug");

  RunChunk(state, kXpcall, "xpcall");
  InstallGuards(state);
  InstallText(state);
  InstallOrder(state);
  InstallPatterns(state);
  InstallOs(state);
}

void RunSource(lua_State* state, const ScriptSource& source, std::string_view name) {
  lua_pushfstring(state, "@%s", std::string(name).c_str());
  const char* chunk = lua_tostring(state, -1);
  const bool is_compiled = !source.compiled.empty();
  const std::string& text = is_compiled ? source.compiled : source.content;
  if (luaL_loadbufferx(state, text.data(), text.size(), chunk, is_compiled ? "b" : "t") != 0) lua_error(state);
  if (!is_compiled) {
    const auto append = [](lua_State*, const void* part, std::size_t size, void* compiled) {
      static_cast<std::string*>(compiled)->append(static_cast<const char*>(part), size);
      return 0;
    };
    if (lua_dump(state, append, &source.compiled) != 0) source.compiled.clear();
  }
  lua_call(state, 0, 0);
  lua_pop(state, 1);
}

void RunChunk(lua_State* state, std::string_view text, std::string_view name) {
  lua_pushfstring(state, "@%s", std::string(name).c_str());
  if (luaL_loadbufferx(state, text.data(), text.size(), lua_tostring(state, -1), "t") != 0) lua_error(state);
  lua_call(state, 0, 0);
  lua_pop(state, 1);
}

void MarkLoaded(lua_State* state, const char* name) {
  lua_getfield(state, LUA_REGISTRYINDEX, "_LOADED");
  lua_pushvalue(state, -2);
  lua_setfield(state, -2, name);
  lua_pop(state, 1);
}

}  // namespace soarbox::script
