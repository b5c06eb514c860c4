// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

struct lua_State;

namespace soarbox::script {

/// What a call with too few or too many arguments does ("arity class" in docs/spec/lua_api.md).
enum class WrongCount : unsigned char {
  kIgnored,  ///< Nothing, with a warning, once per place.
  kError,    ///< A Lua error.
};

/// One function of the sandbox's API. The number of its arguments is checked before `function` runs.
struct Binding {
  const char* name;
  int (*function)(lua_State*);
  int min_arguments;
  int max_arguments;
  WrongCount wrong_count;
};

/// For functions that take any number of arguments.
inline constexpr int kAnyCount = 250;

/// Creates a global table of these functions (or adds them to an existing one) and enters it into package.loaded. The
/// bindings must live as long as the state.
void RegisterTable(lua_State* state, const char* table, std::span<const Binding> bindings);

/// Returns the full name of the running API function, "Agent.GetPosition"; null if it is none.
const char* NameOfRunning(lua_State* state);

/// Warns about the current line of the script; once for each place in a script.
void WarnAtCaller(lua_State* state, std::string message);
/// The same, but reports only the first message about a subject ("radius"), if the messages may differ from call to
/// call.
void WarnAtCallerOnce(lua_State* state, std::string message, std::string_view subject);
/// Warns that the current call was ignored, and why; once for each place in a script.
void WarnIgnored(lua_State* state, const char* why);

}  // namespace soarbox::script
