// SPDX-License-Identifier: BSD-2-Clause
#pragma once

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

/// Notes in a text which variables are to keep their values when it is run: its last line, a comment.
std::string WithKept(std::string text, const std::vector<std::string>& names);
/// The names that WithKept noted; none in any other text.
std::vector<std::string> KeptNames(std::string_view text);

/// Puts the values that variables of these names have now (in globals, and in upvalues of global functions of this
/// script, and of functions that these hold) into a table of the registry.
void CollectKept(lua_State* state, const std::vector<std::string>& names, std::string_view script);
/// Gives those values to the variables of the functions that are there now, and forgets the table.
void RestoreKept(lua_State* state, const std::vector<std::string>& names, std::string_view script);

}  // namespace soarbox::script
