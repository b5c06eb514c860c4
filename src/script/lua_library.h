// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

struct lua_State;

namespace soarbox::script {

struct ScriptSource;

/// Opens the part of the standard library that scripts may use: the base functions, table, string, math, bit,
/// coroutine, debug.traceback, and harmless parts of os; with our own `require` and `print`. Files, processes, bytecode
/// and access to the machine are left out. Call it inside a protected call.
void InstallLibrary(lua_State* state);

/// Compiles and runs a text; raises its errors. Messages use `name` as the file name.
void RunChunk(lua_State* state, std::string_view text, std::string_view name);
/// The same for a file. It is parsed once in a run; other machines reuse the result.
void RunSource(lua_State* state, const ScriptSource& source, std::string_view name);

/// Enters the table on top of the stack into package.loaded, so that `require` of it does nothing.
void MarkLoaded(lua_State* state, const char* name);

}  // namespace soarbox::script
