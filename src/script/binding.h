// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "script/api_table.h"

struct lua_State;

namespace soarbox::script {

/// A function of the API with its parsed arguments. Created once, for all machines of the process.
struct Binding {
  const ApiFunction* function;
  std::vector<ApiArgument> arguments;  ///< From ParseArguments.
  int min_arguments = 0;
  int max_arguments = 0;
  bool needs_check = false;  ///< An argument is not just a value or a truth value.
  /// The function only calculates, so it accepts and returns numbers that are not finite.
  bool takes_any_number = false;
};

/// Creates the global table of this group with its functions and enters it into package.loaded.
void RegisterTable(lua_State* state, const ApiGroup& group);

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
