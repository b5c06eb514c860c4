// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct lua_State;

namespace soarbox::script {

// When an edited script replaces the one that runs, what an agent has come to know should stay. A chunk's locals live
// on as upvalues of its functions: those (and globals) whose declaration is the same in both texts keep their values;
// what the author changed gets the new value. Functions are always the new ones.

/// The top-level variables whose declarations are the same in two versions of a script, in the new one's order.
std::vector<std::string> UnchangedVariables(std::string_view before, std::string_view after);

/// A new version of a file that a machine has run.
struct Reload {
  std::string file;                ///< As scripts call it: "Lib.lua". Empty in old recordings: the main script.
  std::vector<std::string> names;  ///< Variables that keep their values.
};

/// Notes in a text that it is a new version of a file: its last line, a comment.
std::string WithReload(std::string text, const Reload& reload);
/// What WithReload noted; nothing in any other text.
std::optional<Reload> ReadReload(std::string_view text);
/// The text without that line.
std::string_view WithoutReload(std::string_view text);

/// Puts the values that variables of these names have now (in globals, and in upvalues of this script's functions in
/// globals, in tables that globals hold, and in upvalues of such functions) into a table of the registry.
void CollectKept(lua_State* state, const std::vector<std::string>& names, std::string_view script);
/// Gives those values to the variables of the functions that are there now, and forgets the table. A table that is kept
/// receives the functions of the table that the new version made in its place.
void RestoreKept(lua_State* state, const std::vector<std::string>& names, std::string_view script);

}  // namespace soarbox::script
