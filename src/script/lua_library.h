// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

struct lua_State;

namespace soarbox::script {

struct ScriptSource;

/// Opens the standard library as scripts may have it: the language's own functions, table, string, math, bit and
/// coroutine, and what is harmless of os, without files, processes, bytecode or a view into the machine, with `require`
/// and `print` of our own.
/// Call inside a protected call.
void InstallLibrary(lua_State* state);

/// Compiles and runs a text; raises its errors. Messages name `name` as the file.
void RunChunk(lua_State* state, std::string_view text, std::string_view name);
/// The same for a file. It is parsed once in a run: other machines reuse the first one's result.
void RunSource(lua_State* state, const ScriptSource& source, std::string_view name);

/// Enters the table on top of the stack into package.loaded, so that `require` of it does nothing.
void MarkLoaded(lua_State* state, const char* name);

}  // namespace soarbox::script
