// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct lua_State;

namespace soarbox::script {

// When an edited script replaces a running one, an agent should keep its state. A chunk's local variables are upvalues
// of its functions. Upvalues and globals with the same declaration in both texts keep their values. If the author
// changed a declaration, the variable gets the new value. Functions are always the new ones.

/// Returns the top-level variables whose declarations are equal in both versions of a script, in the order of `after`.
std::vector<std::string> UnchangedVariables(std::string_view before, std::string_view after);

/// A new version of a file that a machine has run.
struct Reload {
  std::string file;                ///< The name that scripts use: "Lib.lua". Empty in old recordings: the main script.
  std::vector<std::string> names;  ///< Variables that keep their values.
};

/// Marks a text as a new version of a file, in a comment in its last line.
std::string WithReload(std::string text, const Reload& reload);
/// Reads the mark of WithReload; nothing for other texts.
std::optional<Reload> ReadReload(std::string_view text);
/// The text without that line.
std::string_view WithoutReload(std::string_view text);

/// Copies the current values of variables with these names to a table in the registry. It searches globals, upvalues of
/// this script's functions in globals, tables in globals, and upvalues of functions in these tables.
void CollectKept(lua_State* state, const std::vector<std::string>& names, std::string_view script);
/// Assigns these values to the variables of the current functions, and removes the table. A kept table receives the
/// functions of the table that the new version created in its place.
void RestoreKept(lua_State* state, const std::vector<std::string>& names, std::string_view script);

}  // namespace soarbox::script
