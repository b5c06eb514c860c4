// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <variant>
#include <vector>

struct lua_State;

namespace soarbox::script {

/// A Lua table as plain data: named fields and nested tables. Used for percepts that a script gives to a mind, and for
/// parameters that it gets.
struct TableField {
  std::string name;
  std::variant<double, std::string, std::vector<TableField>> value;
};
using Table = std::vector<TableField>;

/// Copies the table at `index`: the values of keys that are strings, sorted by key. The elements of a list become
/// fields with the list's name. Copies values that are numbers, strings, booleans ("yes", "no"), vectors ({x, y, z}),
/// agents (their names) and tables, at most 8 deep and 1000 in all. Leaves out other values.
Table CopyTable(lua_State* state, int index);
/// Pushes a new table with these fields. If several fields have one name, only the first is used.
void PushTable(lua_State* state, const Table& table);

}  // namespace soarbox::script
