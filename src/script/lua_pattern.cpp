// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_pattern.h"

#include <cstring>
#include <lua.hpp>
#include <string_view>

#include "script/lua_machine.h"
#include "script/nested_call.h"
#include "script/text_pattern.h"

namespace soarbox::script {
namespace {

constexpr std::string_view kSpecials = "^$*+?.([%-";

std::string_view TextAt(lua_State* state, int index) {
  std::size_t length = 0;
  const char* text = luaL_checklstring(state, index, &length);
  return {text, length};
}

/// Finds the first match from `start` on, or only at `start` if `anchored`; kNone if there is none. Raises the
/// pattern's errors.
std::size_t FindMatch(lua_State* state, TextPattern& pattern, std::size_t& start, std::size_t size, bool anchored) {
  LuaMachine& machine = LuaMachine::Of(state);
  const std::uint64_t before = pattern.steps();
  std::size_t end = TextPattern::kNone;
  while (true) {
    end = pattern.MatchAt(start);
    if (end != TextPattern::kNone || pattern.error() || pattern.out_of_steps() || anchored || start >= size) break;
    ++start;
  }
  machine.Charge(pattern.steps() - before);
  if (pattern.error()) luaL_error(state, "%s", pattern.error());
  if (pattern.out_of_steps()) machine.RaiseOutOfBudget(state);
  return end;
}

void PushCapture(lua_State* state, const TextPattern& pattern, int index, std::string_view subject) {
  const TextPattern::Capture& capture = pattern.capture(index);
  if (capture.is_position) {
    lua_pushinteger(state, static_cast<lua_Integer>(capture.start + 1));
  } else {
    lua_pushlstring(state, subject.data() + capture.start, capture.length);
  }
}

/// Pushes all captures, or the entire match if the pattern has none. Returns the number of pushed values.
int PushCaptures(lua_State* state, const TextPattern& pattern, std::string_view subject, std::size_t start,
                 std::size_t end) {
  if (pattern.capture_count() == 0) {
    lua_pushlstring(state, subject.data() + start, end - start);
    return 1;
  }
  luaL_checkstack(state, pattern.capture_count(), "too many captures");
  for (int i = 0; i < pattern.capture_count(); ++i) PushCapture(state, pattern, i, subject);
  return pattern.capture_count();
}

/// Converts Lua's position (from 1; from the end if negative) to an offset.
std::size_t OffsetArgument(lua_State* state, int index, std::size_t size) {
  const auto place = static_cast<std::ptrdiff_t>(luaL_optinteger(state, index, 1));
  const auto length = static_cast<std::ptrdiff_t>(size);
  const std::ptrdiff_t offset = place > 0 ? place - 1 : place < 0 ? place + length : 0;
  return static_cast<std::size_t>(offset < 0 ? 0 : offset > length ? length : offset);
}

int FindOrMatch(lua_State* state, bool find) {
  const std::string_view subject = TextAt(state, 1);
  std::string_view text = TextAt(state, 2);
  std::size_t start = OffsetArgument(state, 3, subject.size());
  if (find && (lua_toboolean(state, 4) || text.find_first_of(kSpecials) == std::string_view::npos)) {
    // memmem takes time in proportion to the sum of both lengths.
    constexpr std::size_t kReadPerInstruction = 16;
    LuaMachine::Of(state).ChargeOrRaise(state, (subject.size() - start + text.size()) / kReadPerInstruction);
    const void* const at = memmem(subject.data() + start, subject.size() - start, text.data(), text.size());
    if (at == nullptr) {
      lua_pushnil(state);
      return 1;
    }
    const auto found = static_cast<std::size_t>(static_cast<const char*>(at) - subject.data());
    lua_pushinteger(state, static_cast<lua_Integer>(found + 1));
    lua_pushinteger(state, static_cast<lua_Integer>(found + text.size()));
    return 2;
  }
  const bool anchored = text.starts_with('^');
  if (anchored) text.remove_prefix(1);
  TextPattern pattern(subject, text, LuaMachine::Of(state).instructions_left());
  const std::size_t end = FindMatch(state, pattern, start, subject.size(), anchored);
  if (end == TextPattern::kNone) {
    lua_pushnil(state);
    return 1;
  }
  if (!find) return PushCaptures(state, pattern, subject, start, end);
  lua_pushinteger(state, static_cast<lua_Integer>(start + 1));
  lua_pushinteger(state, static_cast<lua_Integer>(end));
  return 2 + (pattern.capture_count() > 0 ? PushCaptures(state, pattern, subject, start, end) : 0);
}

int Find(lua_State* state) {
  return FindOrMatch(state, true);
}
int Match(lua_State* state) {
  return FindOrMatch(state, false);
}

/// The step of a gmatch loop. Upvalues: subject, pattern, position of the next search.
int NextMatch(lua_State* state) {
  const std::string_view subject = TextAt(state, lua_upvalueindex(1));
  auto start = static_cast<std::size_t>(lua_tointeger(state, lua_upvalueindex(3)));
  if (start > subject.size()) return 0;
  TextPattern pattern(subject, TextAt(state, lua_upvalueindex(2)), LuaMachine::Of(state).instructions_left());
  const std::size_t end = FindMatch(state, pattern, start, subject.size(), false);
  if (end == TextPattern::kNone) return 0;
  lua_pushinteger(state, static_cast<lua_Integer>(end == start ? end + 1 : end));
  lua_replace(state, lua_upvalueindex(3));
  return PushCaptures(state, pattern, subject, start, end);
}

int GMatch(lua_State* state) {
  TextAt(state, 1);
  TextAt(state, 2);
  lua_settop(state, 2);
  lua_pushinteger(state, 0);
  lua_pushcclosure(state, NextMatch, 3);
  return 1;
}

/// Adds the replacement text of one match: %0 to %9 are captures, % before other characters is that character.
void AddReplacementText(lua_State* state, luaL_Buffer& result, const TextPattern& pattern, std::string_view subject,
                        std::size_t start, std::size_t end) {
  const std::string_view text = TextAt(state, 3);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%' || i + 1 >= text.size()) {
      luaL_addchar(&result, text[i]);
      continue;
    }
    const char c = text[++i];
    const int index = c - '1';
    if (c < '0' || c > '9') {
      luaL_addchar(&result, c);
    } else if (c == '0' || (index == 0 && pattern.capture_count() == 0)) {
      luaL_addlstring(&result, subject.data() + start, end - start);
    } else if (index >= pattern.capture_count()) {
      luaL_error(state, "invalid capture index");
    } else {
      PushCapture(state, pattern, index, subject);
      luaL_addvalue(&result);
    }
  }
}

void AddReplacement(lua_State* state, luaL_Buffer& result, const TextPattern& pattern, std::string_view subject,
                    std::size_t start, std::size_t end) {
  const int type = lua_type(state, 3);
  if (type == LUA_TSTRING || type == LUA_TNUMBER) {
    AddReplacementText(state, result, pattern, subject, start, end);
    return;
  }
  if (type == LUA_TFUNCTION) {
    lua_pushvalue(state, 3);
    const int count = PushCaptures(state, pattern, subject, start, end);
    lua_call(state, count, 1);
  } else {
    if (pattern.capture_count() > 0) {
      PushCapture(state, pattern, 0, subject);
    } else {
      lua_pushlstring(state, subject.data() + start, end - start);
    }
    lua_gettable(state, 3);
  }
  if (!lua_toboolean(state, -1)) {
    lua_pop(state, 1);
    luaL_addlstring(&result, subject.data() + start, end - start);
  } else if (!lua_isstring(state, -1)) {
    luaL_error(state, "invalid replacement value (a %s)", luaL_typename(state, -1));
  } else {
    luaL_addvalue(&result);
  }
}

int GSub(lua_State* state) {
  const NestedCall nested(state);
  const std::string_view subject = TextAt(state, 1);
  std::string_view text = TextAt(state, 2);
  const int type = lua_type(state, 3);
  luaL_argcheck(state, type == LUA_TSTRING || type == LUA_TNUMBER || type == LUA_TFUNCTION || type == LUA_TTABLE, 3,
                "string/function/table expected");
  const lua_Integer most = luaL_optinteger(state, 4, static_cast<lua_Integer>(subject.size() + 1));
  if (type == LUA_TNUMBER) lua_tostring(state, 3);
  const bool anchored = text.starts_with('^');
  if (anchored) text.remove_prefix(1);

  luaL_Buffer result;
  luaL_buffinit(state, &result);
  lua_Integer count = 0;
  std::size_t at = 0;
  while (count < most) {
    TextPattern pattern(subject, text, LuaMachine::Of(state).instructions_left());
    std::size_t start = at;
    const std::size_t end = FindMatch(state, pattern, start, subject.size(), anchored);
    if (end == TextPattern::kNone) break;
    luaL_addlstring(&result, subject.data() + at, start - at);
    ++count;
    // Prices of a match, in addition to the steps of the search.
    constexpr std::size_t kPerMatch = 8, kCopiedPerInstruction = 16;
    const std::size_t copied = start - at + (type == LUA_TSTRING ? lua_objlen(state, 3) : end - start);
    LuaMachine::Of(state).ChargeOrRaise(state, kPerMatch + copied / kCopiedPerInstruction);
    AddReplacement(state, result, pattern, subject, start, end);
    at = end;
    if (end == start) {
      // An empty match: the next character is copied, and the search continues after it.
      if (at >= subject.size()) break;
      luaL_addchar(&result, subject[at++]);
    }
    if (anchored || at > subject.size()) break;
  }
  luaL_addlstring(&result, subject.data() + at, subject.size() - at);
  luaL_pushresult(&result);
  lua_pushinteger(state, count);
  return 2;
}

}  // namespace

void InstallPatterns(lua_State* state) {
  lua_getglobal(state, "string");
  static constexpr luaL_Reg kFunctions[] = {{"find", Find},    {"match", Match}, {"gmatch", GMatch},
                                            {"gfind", GMatch}, {"gsub", GSub},   {nullptr, nullptr}};
  luaL_register(state, nullptr, kFunctions);
  lua_pop(state, 1);
}

}  // namespace soarbox::script
