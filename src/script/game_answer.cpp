// SPDX-License-Identifier: BSD-2-Clause
#include "script/game_answer.h"

#include <lua.hpp>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::script {
namespace {

/// Maximum number of words of a game that are read.
constexpr int kMostWords = 100;

/// Returns the words of the list on top of the stack. Like all functions here, it creates nothing in Lua, so that no
/// Lua error can skip destructors of our strings.
std::vector<std::string> WordsOf(lua_State* state) {
  std::vector<std::string> words;
  for (int i = 1; lua_istable(state, -1) && i <= kMostWords; ++i) {
    lua_rawgeti(state, -1, i);
    const bool is_word = lua_type(state, -1) == LUA_TSTRING;
    if (is_word) words.emplace_back(lua_tostring(state, -1));
    lua_pop(state, 1);
    if (!is_word) break;
  }
  return words;
}

/// ": did you mean north?" or ": it takes north, east".
std::string Remedy(const std::string& given, const std::vector<std::string>& known) {
  if (known.empty()) return {};
  const std::vector<std::string_view> words(known.begin(), known.end());
  if (const std::string_view near = Suggest(given, words); !near.empty())
    return ": did you mean " + std::string(near) + "?";
  std::string text = ": it takes ";
  for (std::size_t i = 0; i < known.size(); ++i) text += (i == 0 ? "" : ", ") + known[i];
  return text;
}

}  // namespace

GameAnswer ReadGameAnswer(lua_State* state) {
  GameAnswer answer;
  const int more = lua_gettop(state), reason = more - 1;
  if (lua_type(state, reason) == LUA_TSTRING) answer.reason = lua_tostring(state, reason);
  if (!lua_istable(state, more)) return answer;
  std::string given;
  std::vector<std::string> known;
  for (lua_pushnil(state); lua_next(state, more) != 0; lua_pop(state, 1)) {
    if (lua_type(state, -2) != LUA_TSTRING) continue;
    const std::string_view name = lua_tostring(state, -2);
    if (name == "known") known = WordsOf(state);
    if (lua_type(state, -1) != LUA_TSTRING) continue;
    if (name == "text") answer.text = lua_tostring(state, -1);
    if (name == "given") given = lua_tostring(state, -1);
    if (name == "drops") answer.drops = lua_tostring(state, -1);
    if (name == "reason") answer.drop_reason = lua_tostring(state, -1);
  }
  if (!answer.text.empty()) answer.text += Remedy(given, known);
  return answer;
}

}  // namespace soarbox::script
