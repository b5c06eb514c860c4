// SPDX-License-Identifier: BSD-2-Clause
#include "script/command_answer.h"

#include <algorithm>
#include <lua.hpp>

namespace soarbox::script {

CommandAnswer ReadCommandAnswer(lua_State* state) {
  CommandAnswer answer;
  const int word = lua_gettop(state) - kCommandResults + 1;
  if (lua_type(state, word) != LUA_TSTRING) return answer;
  const std::string said = lua_tostring(state, word);
  if (said == "running") {
    answer.state = CommandAnswer::State::kRunning;
    if (lua_type(state, word + 1) == LUA_TNUMBER)
      answer.progress = std::clamp(static_cast<float>(lua_tonumber(state, word + 1)), 0.0f, 1.0f);
  } else if (said == "error") {
    answer.state = CommandAnswer::State::kError;
    const bool has_reason = lua_type(state, word + 1) == LUA_TSTRING && lua_objlen(state, word + 1) > 0;
    answer.reason = has_reason ? lua_tostring(state, word + 1) : "refused";
    if (lua_type(state, word + 2) == LUA_TSTRING) answer.text = lua_tostring(state, word + 2);
  } else if (said != "complete") {
    answer.unknown = said;
  }
  return answer;
}

}  // namespace soarbox::script
