// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "diagnostics/diagnostic.h"

struct lua_State;

namespace soarbox::script {

class ScriptPath;

/// An error of a script: what, where, and the calls that led to it.
struct ScriptError {
  Diagnostic diagnostic;
  std::string traceback;  ///< One line for each call, innermost first, with newlines; empty if unknown.
};

/// Formats it as "file:line: error: ...", the source line, and the traceback.
std::string Format(const ScriptError& error);

/// Formats the outer calls of a traceback in one line: "called from Dog.lua:20 (Chase), Dog.lua:33 (Agent_Update)".
/// Empty if there are none.
std::string CallersIn(std::string_view traceback);

/// Converts the error object on top of the stack, while its calls are still on the stack, that is, in a message
/// handler. Does not pop. Never raises.
ScriptError DescribeError(lua_State* state, const ScriptPath& path);

/// The same after the stack is unwound: only the message contains the place. For compile errors and lack of memory.
ScriptError DescribeMessage(std::string_view message, std::string_view script_name, const ScriptPath& path);

/// Returns the Lua calls that led to the current place of a state, innermost first: one line for each, at most 20.
std::string Traceback(lua_State* state);

/// Returns file and line of the innermost running Lua function; an empty file if none runs.
void LocateCaller(lua_State* state, std::string& file, int& line);

}  // namespace soarbox::script
