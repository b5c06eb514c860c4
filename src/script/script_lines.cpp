// SPDX-License-Identifier: BSD-2-Clause
#include <lua.hpp>
#include <set>

#include "script/script_debugger.h"

namespace soarbox::script {

std::vector<int> LinesOfScript(std::string_view text, ScriptLines which) {
  std::set<int> lines;
  lua_State* state = luaL_newstate();
  if (state == nullptr) return {};
  luaL_openlibs(state);
  constexpr const char* kFindLines = R"(
    local util, found = require("jit.util"), {}
    local function look(code, counts)
      for place = 1, util.funcinfo(code).bytecodes - 1 do
        local line = util.funcinfo(code, place).currentline
        if counts and line and line > 0 then found[line] = true end
      end
      for constant = -1, -65536, -1 do
        local inner = util.funck(code, constant)
        if inner == nil then break end
        if type(inner) == "proto" then look(inner, true) end
      end
    end
    look(...)
    return found)";
  const auto find = [&] {
    if (luaL_loadstring(state, kFindLines) != 0) return false;
    if (luaL_loadbufferx(state, text.data(), text.size(), "@script", "t") != 0) return false;
    lua_pushboolean(state, which == ScriptLines::kAll);
    return lua_pcall(state, 2, 1, 0) == 0;
  };
  if (find()) {
    lua_pushnil(state);
    while (lua_next(state, -2) != 0) {
      lines.insert(static_cast<int>(lua_tointeger(state, -2)));
      lua_pop(state, 1);
    }
  }
  lua_close(state);
  return {lines.begin(), lines.end()};
}

}  // namespace soarbox::script
