// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "diagnostics/diagnostic.h"

struct lua_State;

namespace soarbox::script {

class ScriptPath;

/// What went wrong in a script: what, where, and which calls led to it.
struct ScriptError {
  Diagnostic diagnostic;
  std::string traceback;  ///< One line for each call, innermost first, each ending in a newline; empty if unknown.
};

/// "file:line: error: ...", the source line, and the traceback.
std::string Format(const ScriptError& error);

/// The calls of a traceback after the innermost, in one line: "called from Dog.lua:20 (Chase), Dog.lua:33
/// (Agent_Update)". Empty if there is none.
std::string CallersIn(std::string_view traceback);

/// Makes a ScriptError of the error object on top of the stack while the calls that led to it are still on it, that
/// is: in a message handler. Does not pop. Never raises.
ScriptError DescribeError(lua_State* state, const ScriptPath& path);

/// The same after the stack is unwound: only the message gives the place. For compile errors and lack of memory.
ScriptError DescribeMessage(std::string_view message, std::string_view script_name, const ScriptPath& path);

/// The Lua calls that led to where a state is, innermost first: one line for each, at most 20.
std::string Traceback(lua_State* state);

/// The place in the innermost Lua function that runs: its file and line; an empty file if none runs.
void LocateCaller(lua_State* state, std::string& file, int& line);

}  // namespace soarbox::script
