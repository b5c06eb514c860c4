// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

struct lua_State;

namespace soarbox::script {

/// What a call with too few or too many arguments does (spec: arity classes).
enum class WrongCount : unsigned char {
  kIgnored,  ///< Nothing, and a warning, once for each place.
  kError,    ///< A Lua error.
};

class LuaMachine;

/// One function of the sandbox's API: the count of its arguments is checked before `function` runs.
struct Binding {
  const char* name;
  int (*function)(lua_State*);
  int min_arguments;
  int max_arguments;
  WrongCount wrong_count;
  int (*plain)(lua_State*, LuaMachine&) = nullptr;  ///< A short way (plain_call.h); null: there is none.
};

/// For functions that take any number of arguments.
inline constexpr int kAnyCount = 250;

/// Makes a global table of these functions (or adds them to it) and enters it into package.loaded. The bindings must
/// live as long as the state.
void RegisterTable(lua_State* state, const char* table, std::span<const Binding> bindings);

/// Warns of something at the script's line; once for each place in a script.
void WarnAtCaller(lua_State* state, std::string message);
/// The same about a subject ("radius"), whose messages may differ from call to call: reports only the first.
void WarnAtCallerOnce(lua_State* state, std::string message, std::string_view subject);
/// Warns that the call in progress was ignored, and why; once for each place in a script.
void WarnIgnored(lua_State* state, const char* why);

}  // namespace soarbox::script
